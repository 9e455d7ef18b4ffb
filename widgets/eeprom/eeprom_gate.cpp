// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/eeprom/eeprom_gate.h"

#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/on_event.h"
#include "widgets/look/roles.h"
#include "widgets/look/wrapped_label.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QRegularExpression>

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

constexpr int mostTold = 4; // encoders; the table above needs the room

QString placesOf(const std::vector<QPointer<EncoderSession>> &encoders)
{
    QStringList places;
    for (const auto &encoder : encoders)
        places << encoder->place().shown();
    return places.join(u' ');
}

// Places may be typed with commas between them, and have spaces in their names.
QString inBlanks(QString text)
{
    static const QRegularExpression between(QStringLiteral("[\\s,;]+"));
    return u' ' + text.replace(between, QStringLiteral(" ")).trimmed() + u' ';
}

} // namespace

EepromGate::EepromGate(QWidget *parent)
    : QWidget(parent)
    , m_count(wrappedLabel(this, "eepromCount"))
    , m_icon(new QLabel(this))
    , m_text(wrappedLabel(this, "eepromConcern"))
    , m_nevertheless(describe(new QCheckBox(tr("Write &nevertheless"), this), "writeNevertheless",
                              tr("The EEPROM has been written as often as the manual states")))
    , m_place(describe(new QLineEdit(this), "typedPlace", tr("Place, to write nevertheless"),
                       tr("The place of the encoder, so that nothing is written beyond the limit by "
                          "accident")))
{
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(grid::unit);
    grid->setColumnStretch(1, 1);
    grid->addWidget(m_count, 0, 0, 1, 2);
    grid->addWidget(m_icon, 1, 0, Qt::AlignTop);
    grid->addWidget(m_text, 1, 1);
    grid->addWidget(m_nevertheless, 2, 1);
    grid->addWidget(m_place, 3, 1);
    connect(m_nevertheless, &QCheckBox::toggled, this, &EepromGate::changed);
    connect(m_place, &QLineEdit::textChanged, this, &EepromGate::changed);
    hide();
    onEvent(this, {QEvent::PaletteChange, QEvent::StyleChange}, [this] { drawIcon(); });
}

void EepromGate::setWrites(EncoderSession &encoder, int planned)
{
    m_isOne = true;
    take({{&encoder, planned}});
}

void EepromGate::setWrites(std::vector<EepromWrites> writes)
{
    m_isOne = false;
    take(std::move(writes));
}

void EepromGate::take(std::vector<EepromWrites> writes)
{
    for (const EepromWrites &one : m_writes)
        if (one.encoder)
            one.encoder->disconnect(this);
    m_writes = std::move(writes);
    for (const EepromWrites &one : m_writes)
        connect(one.encoder, &EncoderSession::eepromCountChanged, this, [this] {
            showConcern();
            Q_EMIT changed();
        });
    showConcern();
}

void EepromGate::showConcern()
{
    QStringList texts;
    Encoders asked;
    Encoders typed;
    for (const auto &[encoder, planned] : m_writes) {
        const EepromConcern concern = encoder ? eepromConcern(*encoder, planned) : EepromConcern::none;
        if (concern == EepromConcern::none)
            continue;
        const QString text = eepromConcernText(*encoder, planned);
        texts << (m_isOne ? text : QStringLiteral("%1: %2").arg(encoder->place().shown(), text));
        (concern == EepromConcern::typed ? typed : asked).push_back(encoder);
    }
    if (std::exchange(m_asked, asked) != asked)
        m_nevertheless->setChecked(false);
    if (std::exchange(m_typed, typed) != typed)
        m_place->clear();
    if (texts.size() > mostTold)
        texts = texts.first(mostTold) << tr("Other encoders as well: %1.").arg(texts.size() - mostTold);
    const EncoderSession *one = m_isOne ? m_writes.front().encoder.data() : nullptr;
    const QString ask = tr("Type %1 to write nevertheless").arg(placesOf(m_typed));
    m_place->setPlaceholderText(ask);
    m_place->setAccessibleName(ask);
    m_count->setText(one ? eepromCountText(*one) : QString());
    m_count->setVisible(one != nullptr);
    m_text->setText(texts.join(u'\n'));
    m_text->setVisible(!texts.isEmpty());
    m_icon->setVisible(!texts.isEmpty());
    m_nevertheless->setVisible(!m_asked.empty());
    m_place->setVisible(!m_typed.empty());
    setVisible(one || !texts.isEmpty());
    drawIcon();
}

bool EepromGate::isOpen() const
{
    const QString typed = inBlanks(m_place->text());
    const bool allTyped = std::ranges::all_of(m_typed, [&](const QPointer<EncoderSession> &encoder) {
        return encoder && typed.contains(inBlanks(encoder->place().shown()));
    });
    return allTyped && (m_asked.empty() || m_nevertheless->isChecked());
}

void EepromGate::drawIcon()
{
    const Role role = m_typed.empty() ? Role::attention : Role::fault;
    m_icon->setPixmap(
        lineIcon(roleIcon(role), role).pixmap(QSize(grid::smallIcon, grid::smallIcon), devicePixelRatioF()));
}

} // namespace codewheel
