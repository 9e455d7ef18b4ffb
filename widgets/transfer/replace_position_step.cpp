// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/transfer/replace_position_step.h"

#include "bus/buses.h"
#include "catalog/device_description.h"
#include "catalog/total_range.h"
#include "vocabulary/refusal_text.h"
#include "widgets/input/decimal_text.h"
#include "widgets/input/text_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_radio_button.h"

#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QRadioButton>
#include <QShortcutEvent>

#include <utility>

namespace codewheel {
namespace {

bool showsOtherThan(const std::optional<SeenPosition> &before, const std::optional<SeenPosition> &now)
{
    return before.has_value() != now.has_value() ||
           (now && (before->position != now->position || before->since != now->since ||
                    before->scaled != now->scaled));
}

// Not the position now of an encoder that is there.
bool saysOtherThan(const std::optional<SeenPosition> &before, const std::optional<SeenPosition> &now)
{
    using Since = SeenPosition::Since;
    const bool areThere = before && now && before->since == Since::there && now->since == Since::there;
    return !areThere && showsOtherThan(before, now);
}

} // namespace

ReplacePositionStep::ReplacePositionStep(Replacing &replacing, const LastPositions &positions,
                                         QWidget *parent)
    : ReplaceStep(replacing, tr("Position"), parent)
    , m_positions(positions)
    , m_last(describe(new WrappedRadioButton(tr("&Position of the previous encoder"), this), "positionLast",
                      tr("The last position of the previous encoder")))
    , m_newest(
          describe(new WrappedRadioButton(tr("Position since &then"), this), "positionNewest",
                   tr("The last position that was seen: right if the encoder that came back is the previous "
                      "one, and not the new one")))
    , m_kept(describe(new WrappedRadioButton(tr("Position kept in the pro&ject"), this), "positionKept",
                      tr("The last position of the previous encoder when the project was saved")))
    , m_typed(describe(new QRadioButton(tr("&Set the position to"), this), "positionTyped",
                       tr("From your notes, or from where the machine stands")))
    , m_none(describe(new WrappedRadioButton(tr("&Leave the position as the new encoder shows it"), this),
                      "positionNone", tr("Nothing is set: the machine has to be referenced another way")))
    , m_value(describe(new TextField(this), "positionValue", tr("Position in steps"),
                       tr("Position in steps, decimal or hexadecimal (0x.. or ..h)")))
    , m_note(new QLabel(tr("The shaft must stand where it stood then. The zero offset of the previous "
                           "encoder is not written: setting the position makes a new one. A preset that the "
                           "project wants is written last, and does not act by itself."),
                        this))
    , m_message(new InlineMessage(this))
{
    m_value->setMaximumWidth(160);
    m_note->setWordWrap(true);
    layOutColumn(this,
                 {m_last, m_newest, m_kept,
                  layOutRow({m_typed, m_value, new QLabel(tr("steps"), this), Stretch{1}}), m_none, m_message,
                  m_note, Stretch{1}},
                 {.spacing = grid::margin, .margins = QMargins()});
    m_typed->installEventFilter(this);
    connect(&replacing.buses, &Buses::updated, this, [this] {
        if (isVisible())
            lookAgain();
    });
    connect(m_value, &QLineEdit::textEdited, this, [this] { m_typed->setChecked(true); });
    for (QRadioButton *one : std::initializer_list<QRadioButton *>{m_last, m_newest, m_kept, m_typed, m_none})
        connect(one, &QRadioButton::toggled, this, &ReplacePositionStep::noteChoice);
}

// Its key is for the number that belongs to it.
bool ReplacePositionStep::eventFilter(QObject *watched, QEvent *event)
{
    const bool isKey = watched == m_typed && event->type() == QEvent::Shortcut &&
                       !static_cast<QShortcutEvent *>(event)->isAmbiguous();
    if (!isKey)
        return ReplaceStep::eventFilter(watched, event);
    m_typed->setChecked(true);
    m_value->setFocus(Qt::ShortcutFocusReason);
    m_value->selectAll();
    return true;
}

// Of an encoder that is there all the time, and turns, it is the same offer.
void ReplacePositionStep::lookAgain()
{
    const auto seen = std::exchange(m_seen, m_positions.at(m_replacing.place));
    const auto since = std::exchange(m_since, m_positions.newest(m_replacing.place));
    if (m_since == m_seen)
        m_since.reset();
    if (showsOtherThan(seen, m_seen) || showsOtherThan(since, m_since))
        showOffers();
    if ((!m_last->isChecked() || !saysOtherThan(seen, m_seen)) &&
        (!m_newest->isChecked() || !saysOtherThan(since, m_since)))
        return;
    chooseNone();
    askAgain(tr("The bus was stopped or the encoder was away since the position was chosen. Choose it once "
                "more."));
}

void ReplacePositionStep::enter()
{
    m_message->withdraw();
    lookAgain();
    const auto &kept = m_replacing.before.lastPosition;
    m_ofProject =
        kept ? std::optional(m_positions.kept(m_replacing.place, *kept, newSettings())) : std::nullopt;
    showOffers();
    if (isChosenOther() && !m_isOther) {
        chooseNone();
        askAnew();
    } else if (m_mustChoose) {
        askAgain(m_whyAgain);
    }
    if (!m_mustChoose && chosen() == nullptr)
        preselect();
    QRadioButton *one = chosen();
    setFocusProxy(one == m_typed ? static_cast<QWidget *>(m_value) : one != nullptr ? one : m_none);
}

void ReplacePositionStep::preselect()
{
    const bool presets = m_typed->isEnabled();
    const bool isAwayAgain = m_since && m_since->since == SeenPosition::Since::gone;
    const bool isOfOld = m_seen && !isAwayAgain && m_seen->since == SeenPosition::Since::gone &&
                         m_seen->scaled == SeenPosition::Scaled::asThen && !isWantedOtherwise(m_seen->scale);
    (presets ? isOfOld ? m_last : m_typed : m_none)->setChecked(true);
}

void ReplacePositionStep::noteChoice(bool isOn)
{
    if (!isOn)
        return;
    m_isOther = isChosenOther();
    m_mustChoose = false;
}

// A choice that has become another position must not be written by a mere Next.
void ReplacePositionStep::chooseNone()
{
    m_mustChoose = true;
    QRadioButton *one = chosen();
    one->setAutoExclusive(false); // otherwise one of them stays chosen
    one->setChecked(false);
    one->setAutoExclusive(true);
}

bool ReplacePositionStep::isOther(const SeenPosition &seen) const
{
    return seen.scaled == SeenPosition::Scaled::otherwise || isWantedOtherwise(seen.scale);
}

bool ReplacePositionStep::isChosenOther() const
{
    return (m_last->isChecked() && m_seen && isOther(*m_seen)) ||
           (m_newest->isChecked() && m_since && isOther(*m_since)) ||
           (m_kept->isChecked() && m_ofProject && isOther(*m_ofProject));
}

void ReplacePositionStep::showOffers()
{
    const bool presets = m_replacing.now.device != nullptr && m_replacing.now.device->capabilities.presets;
    m_last->setVisible(m_seen && presets);
    m_newest->setVisible(m_since && presets);
    m_kept->setVisible(m_ofProject && presets);
    m_typed->setEnabled(presets);
    m_value->setEnabled(presets);
    const QLocale locale;
    if (m_seen) {
        const QString position = locale.toString(qlonglong{m_seen->position});
        const QString time = locale.toString(m_seen->at, QLocale::ShortFormat);
        m_last->setText(textOf(*m_seen).arg(position, time));
        m_last->setToolTip(tipOf(*m_seen));
    }
    if (m_since)
        m_newest->setText(withScale(
            tr("Position %1, shown since &then, at %2 last: of the previous encoder only if the one "
               "that came back is not the new one")
                .arg(locale.toString(qlonglong{m_since->position}),
                     locale.toString(m_since->at, QLocale::ShortFormat)),
            m_since->scale));
    if (m_ofProject)
        m_kept->setText(keptText(*m_ofProject));
}

// What nobody knew of its scale when it was kept cannot be compared.
QString ReplacePositionStep::keptText(const SeenPosition &kept) const
{
    const QLocale locale;
    const QString text =
        tr("Position %1, kept in the pro&ject: seen at %2")
            .arg(locale.toString(qlonglong{kept.position}), locale.toString(kept.at, QLocale::ShortFormat));
    const bool isMarked = isOther(kept);
    if (!isMarked && !isScaleKnown(kept.scale))
        return tr("%1. How the encoder was scaled then is not known: it is right if its scale was the same.",
                  "most of a sentence")
            .arg(text);
    const bool isAsThen = !isMarked && kept.scaled == SeenPosition::Scaled::asThen;
    if (isAsThen && !isScaleKnown(kept.scale, newSettings()))
        return tr("%1. How the encoder was scaled then is not known in full: it is right if all of its scale "
                  "was the same.",
                  "most of a sentence")
            .arg(text);
    return scaledText(text, kept);
}

bool ReplacePositionStep::isWantedOtherwise(const ParameterValues &scale) const
{
    return isOfAnotherScale(scale, newSettings());
}

// `scale`: with which the position was seen.
QString ReplacePositionStep::withScale(const QString &text, const ParameterValues &scale) const
{
    if (!isWantedOtherwise(scale))
        return text;
    return tr("%1 It is of another scale than the wanted one: with that, it is another position.",
              "a sentence, or most of one")
        .arg(text.endsWith(u'.') ? text : text + u'.');
}

QString ReplacePositionStep::textOf(const SeenPosition &seen) const
{
    const bool isThere = seen.since == SeenPosition::Since::there;
    const QString text = isThere ? tr("&Position %1, shown at %2; not away since")
                         : seen.since == SeenPosition::Since::gone
                             ? tr("&Position %1, seen at %2, before the encoder went away")
                             : tr("&Position %1, seen at %2. Then nobody saw the encoder for a while; it was "
                                  "not seen to be away.");
    return scaledText(text, seen);
}

QString ReplacePositionStep::scaledText(const QString &text, const SeenPosition &seen) const
{
    const QString whole = text.endsWith(u'.') ? text : text + u'.';
    switch (seen.scaled) {
    case SeenPosition::Scaled::otherwise:
        return tr("%1 The encoder was scaled otherwise then: now this is another position.",
                  "a sentence, or most of one")
            .arg(whole);
    case SeenPosition::Scaled::perhapsOtherwise:
        return tr("%1 Since then values of its scale, or its position, were written here: it is right if the "
                  "previous encoder had the same scale.",
                  "a sentence, or most of one")
            .arg(withScale(whole, seen.scale));
    case SeenPosition::Scaled::asThen:
        break;
    }
    return withScale(text, seen.scale);
}

QString ReplacePositionStep::tipOf(const SeenPosition &seen)
{
    switch (seen.since) {
    case SeenPosition::Since::there:
        return tr("The encoder has not been away since: it may still be the previous one");
    case SeenPosition::Since::unwatched:
        return tr("The computer slept, or the bus was stopped or lost: the encoder may still be the previous "
                  "one");
    case SeenPosition::Since::gone:
        break;
    }
    return tr("The position that was seen last, and when");
}

QRadioButton *ReplacePositionStep::chosen() const
{
    for (QRadioButton *one : {m_last, m_newest, m_kept, m_typed, m_none})
        if (one->isChecked())
            return one;
    return nullptr;
}

void ReplacePositionStep::takeSeen(const SeenPosition &seen)
{
    m_replacing.position = seen.position;
    for (const ParameterValue &value : seen.scale)
        replaceValue(m_scale, value);
}

void ReplacePositionStep::takeTyped()
{
    const QString text = m_value->text().trimmed();
    const auto position = readWhole(text);
    if (position && *position >= 0)
        m_replacing.position = *position;
    else
        m_message->showMessage(
            Role::attention,
            position || text.isEmpty()
                ? tr("Give the position as a whole number, 0 or more, or leave it unchanged.")
                : position.error());
}

// What is written to the new encoder.
ParameterValues ReplacePositionStep::newSettings() const
{
    return settingsOfNew(m_replacing.before, m_replacing.now.device);
}

// With what is written to it the encoder counts no further than that.
std::optional<std::int64_t> ReplacePositionStep::newRange() const
{
    return m_replacing.now.device->hasWords() ? totalRange(*m_replacing.now.device, newSettings())
                                              : std::nullopt;
}

bool ReplacePositionStep::stillHolds() const
{
    if (!m_replacing.position)
        return true;
    const bool isOtherNow = isWantedOtherwise(m_scale) && newSettings() != m_settings;
    const auto total = newRange();
    return !isOtherNow && (!total || *m_replacing.position < *total);
}

void ReplacePositionStep::askAnew()
{
    askAgain(tr("Other values are wanted than when the position was chosen: with them it may be another "
                "place. Choose it once more."));
}

void ReplacePositionStep::askAgain(const QString &why)
{
    m_whyAgain = why;
    m_message->showMessage(Role::attention, why);
}

// It would refuse the position, with the rest written.
void ReplacePositionStep::refuseBeyondRange()
{
    const auto total = newRange();
    if (!total || *m_replacing.position < *total)
        return;
    m_message->showMessage(Role::attention,
                           refusalText({RefusalKind::badInput,
                                        RefusalId::valueAboveTotalRange,
                                        {Parameter::preset, *m_replacing.position, *total - 1}}));
    m_replacing.position.reset();
}

bool ReplacePositionStep::leave()
{
    m_message->withdraw();
    m_replacing.position.reset();
    if (m_none->isChecked())
        return true;
    if (chosen() == nullptr) {
        askAgain(m_whyAgain);
        return false;
    }
    m_scale = m_settings = newSettings();
    if (m_last->isChecked() && m_seen)
        takeSeen(*m_seen);
    else if (m_newest->isChecked() && m_since)
        takeSeen(*m_since);
    else if (m_kept->isChecked() && m_ofProject)
        takeSeen(*m_ofProject);
    else
        takeTyped();
    if (m_replacing.position)
        refuseBeyondRange();
    return m_replacing.position.has_value();
}

} // namespace codewheel
