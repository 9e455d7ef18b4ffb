// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/faults/desktop_notice.h"

#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QFileInfo>
#include <QGuiApplication>
#include <QVariantMap>

#include <utility>

namespace codewheel {
namespace {

const QString notificationService = QStringLiteral("org.freedesktop.Notifications");
const QString notificationPath = QStringLiteral("/org/freedesktop/Notifications");
constexpr int longestAnswer = 5'000; // ms
constexpr uchar critical = 2;        // stays until it is seen

// Of the user's session; empty: none. Without an address, libdbus would start a bus of its own.
QString desktopAddress()
{
    constexpr const char *variable = "DBUS_SESSION_BUS_ADDRESS";
    if (qEnvironmentVariableIsSet(variable))
        return qEnvironmentVariable(variable);
    const QString usual = qEnvironmentVariable("XDG_RUNTIME_DIR") + QStringLiteral("/bus");
    return QFileInfo::exists(usual) ? QStringLiteral("unix:path=") + usual : QString();
}

QDBusConnection connectToDesktop()
{
    static int connections = 0;
    const QString address = desktopAddress();
    const QString name = QStringLiteral("codewheel-%1").arg(++connections);
    return address.isEmpty() ? QDBusConnection(name) : QDBusConnection::connectToBus(address, name);
}

QVariantMap hintsOf(const DesktopNotice::Text &text)
{
    QVariantMap hints{{QStringLiteral("urgency"), QVariant::fromValue(critical)},
                      {QStringLiteral("category"), QStringLiteral("device.error")},
                      {QStringLiteral("desktop-entry"), QStringLiteral("io.codewheel.Codewheel")}};
    if (text.withSound)
        hints.insert(QStringLiteral("sound-name"), QStringLiteral("dialog-error"));
    else
        hints.insert(QStringLiteral("suppress-sound"), true);
    return hints;
}

} // namespace

DesktopNotice::DesktopNotice(QObject *parent)
    : QObject(parent)
    , m_desktop(connectToDesktop())
{
    // From any sender: asking who the service is would wait for an answer.
    const auto listen = [this](const char *signal, const char *slot) {
        m_desktop.connect({}, notificationPath, notificationService, QLatin1String(signal), this, slot);
    };
    listen("ActionInvoked", SLOT(takeAction(uint, QString)));
    listen("ActivationToken", SLOT(takeToken(uint, QString)));
    listen("NotificationClosed", SLOT(takeEnd(uint, uint)));
}

DesktopNotice::~DesktopNotice()
{
    QDBusConnection::disconnectFromBus(m_desktop.name());
}

void DesktopNotice::show(const Text &text)
{
    m_next = text;
    m_isWanted = true;
    goOn();
}

void DesktopNotice::withdraw()
{
    m_next.reset();
    m_isWanted = false;
    if (const uint shown = std::exchange(m_shown, 0); shown != 0)
        call("CloseNotification", {shown}, {});
}

void DesktopNotice::call(const char *method, const QVariantList &arguments, const Answer &then)
{
    QDBusMessage message = QDBusMessage::createMethodCall(notificationService, notificationPath,
                                                          notificationService, QLatin1String(method));
    message.setArguments(arguments);
    if (!then) {
        m_desktop.send(message);
        return;
    }
    auto *watcher = new QDBusPendingCallWatcher(m_desktop.asyncCall(message, longestAnswer), this);
    connect(watcher, &QDBusPendingCallWatcher::finished, this, [watcher, then] {
        watcher->deleteLater();
        then(watcher->reply());
    });
}

void DesktopNotice::goOn()
{
    if (m_isBusy || !m_next)
        return;
    if (!m_desktop.isConnected())
        failed(*std::exchange(m_next, {}));
    else if (m_can)
        send(*std::exchange(m_next, {}));
    else
        askWhatItCan();
}

void DesktopNotice::askWhatItCan()
{
    m_isBusy = true;
    call("GetCapabilities", {}, [this](const QDBusMessage &answer) {
        m_isBusy = false;
        if (answer.type() == QDBusMessage::ReplyMessage)
            m_can = answer.arguments().value(0).toStringList();
        else if (m_next)
            failed(*std::exchange(m_next, {}));
        goOn();
    });
}

void DesktopNotice::send(const Text &text)
{
    m_isBusy = true;
    const bool hasMarkup = m_can->contains(QStringLiteral("body-markup"));
    const QStringList actions = m_can->contains(QStringLiteral("actions"))
                                    ? QStringList{QStringLiteral("default"), tr("Show")}
                                    : QStringList();
    const QVariantList arguments{QGuiApplication::applicationDisplayName(),
                                 m_shown,
                                 QStringLiteral("io.codewheel.Codewheel"),
                                 text.title,
                                 hasMarkup ? text.body.toHtmlEscaped() : text.body,
                                 actions,
                                 hintsOf(text),
                                 -1}; // as long as the desktop shows such notices
    call("Notify", arguments, [this, text](const QDBusMessage &answer) {
        m_isBusy = false;
        if (answer.type() == QDBusMessage::ReplyMessage)
            m_shown = answer.arguments().value(0).toUInt();
        else
            failed(text);
        if (!m_isWanted)
            withdraw();
        goOn();
    });
    if (text.withSound && !m_can->contains(QStringLiteral("sound")))
        Q_EMIT staysSilent();
}

// Another service may be there the next time.
void DesktopNotice::failed(const Text &text)
{
    m_shown = 0;
    const bool couldSound = !m_can || m_can->contains(QStringLiteral("sound"));
    m_can.reset();
    if (text.withSound && couldSound)
        Q_EMIT staysSilent();
}

void DesktopNotice::takeAction(uint id, const QString &action)
{
    if (id == m_shown && action == QStringLiteral("default"))
        Q_EMIT clicked();
}

// With it, Wayland lets the window come to the front.
void DesktopNotice::takeToken(uint id, const QString &token)
{
    if (id == m_shown)
        qputenv("XDG_ACTIVATION_TOKEN", token.toUtf8());
}

void DesktopNotice::takeEnd(uint id, uint)
{
    if (id == m_shown)
        m_shown = 0;
}

} // namespace codewheel
