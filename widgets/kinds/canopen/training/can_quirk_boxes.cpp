// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/training/can_quirk_boxes.h"

#include "kinds/canopen/simulator/can_training_acts.h"
#include "vocabulary/enumeration_rows.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/training/training_fields.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QVBoxLayout>

#include <array>

namespace codewheel {
namespace {

struct QuirkTip
{
    const char *key;
    const char *text;
};
constexpr std::array quirkTips{
    QuirkTip{"autostart", QT_TRANSLATE_NOOP("codewheel::CanQuirkBoxes",
                                            "Operational after boot-up, without being started")},
    QuirkTip{"fixed-mapping",
             QT_TRANSLATE_NOOP("codewheel::CanQuirkBoxes", "Which objects stand in a PDO cannot be changed")},
    QuirkTip{"highest-range",
             QT_TRANSLATE_NOOP("codewheel::CanQuirkBoxes",
                               "6002h has the highest position, and not how many there are")},
    QuirkTip{"keeps-identifiers",
             QT_TRANSLATE_NOOP("codewheel::CanQuirkBoxes",
                               "Identifiers that were stored do not follow a new node number")},
    QuirkTip{"keeps-preset", QT_TRANSLATE_NOOP("codewheel::CanQuirkBoxes",
                                               "A preset is kept without power, without being stored")},
    QuirkTip{"lss-forgets",
             QT_TRANSLATE_NOOP("codewheel::CanQuirkBoxes",
                               "Number and rate are stored by 1010h only, though LSS says that they are")},
    QuirkTip{"lss-stopped",
             QT_TRANSLATE_NOOP("codewheel::CanQuirkBoxes", "It takes part in LSS only while it is stopped")},
    QuirkTip{"restore-at-once",
             QT_TRANSLATE_NOOP("codewheel::CanQuirkBoxes",
                               "Factory values are in force at once, and lost unless they are stored")},
    QuirkTip{"silent-store",
             QT_TRANSLATE_NOOP("codewheel::CanQuirkBoxes", "For 0.4 s it neither hears nor says anything")},
    QuirkTip{"speed-off",
             QT_TRANSLATE_NOOP("codewheel::CanQuirkBoxes", "6030h is 0 until 3010h:1 is set to 1")},
    QuirkTip{"switches",
             QT_TRANSLATE_NOOP("codewheel::CanQuirkBoxes", "Its switches have the number: 2000h is refused")},
    QuirkTip{"writes-pre-operational",
             QT_TRANSLATE_NOOP("codewheel::CanQuirkBoxes", "While it is operational, writes are refused")},
};

QString quirkTipOf(const char *key)
{
    const QuirkTip *row = rowByKey(quirkTips, QString::fromLatin1(key));
    return row != nullptr ? CanQuirkBoxes::tr(row->text) : QString();
}

} // namespace

CanQuirkBoxes::CanQuirkBoxes(QWidget *parent)
    : QWidget(parent)
{
    auto *column = layOut<QVBoxLayout>(this, grid::unit);
    auto *caption = wrappedLabel(this);
    caption->setText(tr("As some makes are; with each change the encoder begins anew:"));
    column->addWidget(caption);
    for (const canopen::NamedQuirk &quirk : canopen::namedQuirks()) {
        m_boxes.push_back(training_fields::addBox(column, nodeQuirkName(quirk.key), quirkTipOf(quirk.key)));
        connect(m_boxes.back(), &QCheckBox::clicked, this,
                [this, &quirk](bool on) { Q_EMIT quirkSet(quirk, on); });
    }
}

void CanQuirkBoxes::showQuirks(const canopen::NodeQuirks &quirks)
{
    const auto rows = canopen::namedQuirks();
    for (std::size_t row = 0; row < rows.size(); ++row)
        m_boxes[row]->setChecked(rows[row].isIn(quirks));
}

} // namespace codewheel
