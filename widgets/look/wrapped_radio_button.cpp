// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/wrapped_radio_button.h"

#include <QStyleOptionButton>

namespace codewheel {

WrappedRadioButton::WrappedRadioButton(const QString &text, QWidget *parent)
    : QRadioButton(text, parent)
{
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum, QSizePolicy::RadioButton);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

QSize WrappedRadioButton::sizeWith(const QString &text) const
{
    QStyleOptionButton option;
    QRadioButton::initStyleOption(&option);
    option.text = text;
    const QSize size = style()->itemTextRect(fontMetrics(), {}, Qt::TextShowMnemonic, false, text).size();
    return style()->sizeFromContents(QStyle::CT_RadioButton, &option, size, this);
}

QString WrappedRadioButton::brokenText(int width) const
{
    QString whole;
    QString line;
    for (const QString &word : text().split(u' ')) {
        const QString longer = line.isEmpty() ? word : line + u' ' + word;
        if (line.isEmpty() || sizeWith(longer).width() <= width) {
            line = longer;
        } else {
            whole += line + u'\n';
            line = word;
        }
    }
    return whole + line;
}

QSize WrappedRadioButton::minimumSizeHint() const
{
    QSize size;
    for (const QString &word : text().split(u' '))
        size = size.expandedTo(sizeWith(word));
    return size;
}

int WrappedRadioButton::heightForWidth(int width) const
{
    return sizeWith(brokenText(width)).height();
}

void WrappedRadioButton::initStyleOption(QStyleOptionButton *option) const
{
    QRadioButton::initStyleOption(option);
    option->text = brokenText(width());
}

} // namespace codewheel
