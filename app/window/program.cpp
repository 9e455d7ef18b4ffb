// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/program.h"

#include "app/journal_files.h"
#include "app/user_devices.h"
#include "app/window/buses/plant.h"
#include "app/window/connect/start.h"
#include "app/window/faults/unseen_faults.h"
#include "app/window/files/project_recovery.h"
#include "app/window/main_window.h"
#include "app/window/recording/recording_in_window.h"
#include "app/window/start_probe.h"
#include "app/window/work_in_window.h"
#include "journal/eeprom_cost.h"
#include "journal/ledger_writer.h"
#include "widgets/messages/message_model.h"

#include <QApplication>
#include <QFileInfo>
#include <QStandardPaths>
#include <QTimer>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr qint64 megabyte = 1'000'000;
constexpr auto betweenTriesToGo = 500ms;
constexpr auto measuredRun = 2s; // after which a measured start ends

} // namespace

Program::Program(QApplication &application, const QString &settingsFile)
    : m_application(application)
    , m_dataFolder(settingsFile.isEmpty() ? userJournalFolder() : QFileInfo(settingsFile).absolutePath())
    , m_recoveryFolder((settingsFile.isEmpty()
                            ? QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)
                            : QFileInfo(settingsFile).path()) +
                       QStringLiteral("/recovery"))
    , m_settings(settingsFile)
    , m_choices(m_settings, {m_dataFolder, m_recoveryFolder, userDeviceFolder()})
{
    applyAppearance(application, m_choices.now().appearance);
    useLanguage();
    useSettings();
    connect(&m_choices, &SettingsAtWork::changed, this, &Program::useSettings);
    connect(&m_choices, &SettingsAtWork::appearanceChanged, this,
            [this] { applyAppearance(m_application, m_choices.now().appearance); });
    connect(&m_choices, &SettingsAtWork::languageChanged, this, &Program::makeWindowAnew,
            Qt::QueuedConnection); // the request comes from the window itself
    m_lastFile = m_settings.lastFile();
    connect(&m_project, &ProjectDocument::fileChanged, this, &Program::keepLastFile);
}

Program::~Program()
{
    m_frames.stop();
    m_window.reset(); // before the sessions it shows
}

int Program::run()
{
    openWindow();
    m_window->show();
    return QApplication::exec();
}

// Makes only the window until it is seen; the bus comes afterwards.
void Program::openWindow()
{
    m_window = std::make_unique<MainWindow>(m_settings, m_project);
    m_frames.setWindow(*m_window);
    connect(m_window.get(), &MainWindow::languageChosen, this, [this](const QString &language) {
        ProgramSettings settings = m_choices.now();
        settings.language = language;
        m_choices.use(settings);
    });
    connect(m_window.get(), &MainWindow::appearanceChosen, &m_choices, &SettingsAtWork::takeAppearance);
    connect(m_window.get(), &MainWindow::settingsRequested, this, [this] { m_choices.open(*m_window); });
    if (m_plant) {
        attach();
        m_window->askForRecovery(*m_recovery);
    } else
        connect(m_window.get(), &MainWindow::firstPainted, this, &Program::startBus);
}

void Program::startBus()
{
    const bool measured = reportFirstPaint();
    m_catalog = std::make_unique<Catalog>(Catalog::builtIn());
    const std::vector<Catalog::Fault> faults = addUserDevices(*m_catalog, userDeviceFolder());
    m_store = std::make_unique<MessageStore>(MessageStore::Settings{
        .file = messageFile(m_dataFolder), .largestSize = m_choices.now().largestMessageFile * megabyte});
    m_messages = std::make_unique<MessageModel>(*m_store);
    m_plant = std::make_unique<Plant>(BusAtWork::Surroundings{
        .catalog = *m_catalog, .project = m_project, .dataFolder = m_dataFolder, .clock = [] {
            return QDateTime::currentDateTime();
        }});
    connect(m_plant.get(), &Plant::messaged, m_messages.get(), &MessageModel::add);
    watchFaults();
    const bool isFirst = m_file.isEmpty() && m_settings.isFirstStart();
    m_settings.noteStart();
    if (isFirst)
        m_plant->openTraining();
    for (const Catalog::Fault &fault : faults)
        m_messages->addNow(
            {.severity = Severity::attention,
             .refusal =
                 Refusal{RefusalKind::badInput, RefusalId::deviceFileBroken, {fault.place(), fault.reason}}});
    attach();
    if (isFirst)
        m_window->showFirstTime();
    openProject();
    m_plant->start();
    m_frames.start();
    if (measured)
        QTimer::singleShot(measuredRun, &m_application, [] {
            reportMemory();
            QCoreApplication::exit();
        });
}

void Program::watchFaults()
{
    m_unseenFaults = std::make_unique<UnseenFaults>();
    connect(m_messages.get(), &MessageModel::added, m_unseenFaults.get(), &UnseenFaults::take);
    connect(m_unseenFaults.get(), &UnseenFaults::told, this, [this] { QApplication::alert(m_window.get()); });
    connect(m_unseenFaults.get(), &UnseenFaults::beepWanted, this, &QApplication::beep);
    connect(m_unseenFaults.get(), &UnseenFaults::windowWanted, this, &Program::raiseWindow);
}

// For the next start to offer, even after a crash.
void Program::keepLastFile()
{
    m_settings.setLastFile(m_project.file());
    if (!m_project.file().isEmpty())
        m_lastFile.clear();
}

void Program::openProject()
{
    if (!m_file.isEmpty())
        m_window->openFile(m_file);
    m_window->compare();
    m_recovery = std::make_unique<ProjectRecovery>(m_project, m_recoveryFolder);
    connect(m_recovery.get(), &ProjectRecovery::told, m_messages.get(), &MessageModel::addNow);
    m_window->askForRecovery(*m_recovery);
    useSettings();
}

void Program::attach()
{
    m_window->attach(*m_plant, *m_messages);
    m_window->start().offer(m_lastFile);
    if (const auto warning = nothingIsKept(); !warning.isEmpty())
        m_window->warn(warning);
}

void Program::useSettings()
{
    const ProgramSettings &now = m_choices.now();
    m_frames.setRate(now.framesPerSecond);
    if (m_unseenFaults)
        m_unseenFaults->setWishes(now.notifiesOfFaults, now.notifiesWithSound);
    askFromEepromShare(now.eepromQuestionFrom);
    setLedgerUser(now.userName);
    if (m_recovery)
        m_recovery->setPeriod(std::chrono::seconds(now.secondsBetweenKeeping));
    if (m_window)
        m_window->showSettings();
}

void Program::useLanguage()
{
    const DecimalSign sign = m_choices.now().decimalSign;
    m_language.use(m_choices.now().language, sign == DecimalSign::point   ? u"."
                                             : sign == DecimalSign::comma ? u","
                                                                          : u"");
}

// All texts are made with the window, so it is rebuilt; bus, jobs and messages go on.
void Program::makeWindowAnew()
{
    if (!m_window->mayGo()) {
        QTimer::singleShot(betweenTriesToGo, this, &Program::makeWindowAnew);
        return;
    }
    m_window->saveWindow();
    useLanguage();
    m_project.nameStepsAnew();
    const bool visible = m_window->isVisible();
    const auto pinned = m_window->pinnedDial();
    WorkInWindow work = m_window->takeWork();
    const bool showsRecording = m_plant && m_window->recording().showsDetails();
    m_window.reset();
    if (m_plant)
        m_plant->nameAnew();
    openWindow();
    if (pinned)
        m_window->pinDial(*pinned);
    m_window->setVisible(visible);
    m_window->goOn(std::move(work));
    if (showsRecording)
        m_window->recording().openDetails();
    m_choices.goOnIn(*m_window);
}

void Program::raiseWindow()
{
    m_window->setWindowState((m_window->windowState() & ~Qt::WindowMinimized) | Qt::WindowActive);
    m_window->show();
    m_window->raise();
    m_window->activateWindow();
}

} // namespace codewheel
