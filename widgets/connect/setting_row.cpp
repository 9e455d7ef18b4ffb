// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connect/setting_row.h"

#include "widgets/look/fonts.h"
#include "widgets/look/wrapped_label.h"

#include <QFormLayout>
#include <QLabel>

namespace codewheel {

QLabel *settingSentence(const QString &sentence, QWidget *parent)
{
    auto *label = wrappedLabel(parent, "settingSentence");
    label->setFont(textFont(TextSize::small));
    label->setText(sentence);
    return label;
}

QLabel *addSettingRow(QFormLayout &form, const QString &label, LayoutPart field, QWidget *buddy,
                      const QString &sentence)
{
    auto *below = settingSentence(sentence, form.parentWidget());
    auto *row = layOutColumn({field, below}, {.spacing = 0});
    form.addRow(label, row);
    if (auto *shown = qobject_cast<QLabel *>(form.labelForField(row)))
        shown->setBuddy(buddy);
    return below;
}

} // namespace codewheel
