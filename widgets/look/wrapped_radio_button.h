// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRadioButton>

namespace codewheel {

// A radio button whose text breaks between words where one line has no room for it.
class WrappedRadioButton final : public QRadioButton
{
    Q_OBJECT

public:
    explicit WrappedRadioButton(const QString &text, QWidget *parent = nullptr);

    QSize minimumSizeHint() const override; // with its longest word
    int heightForWidth(int width) const override;

protected:
    void initStyleOption(QStyleOptionButton *option) const override;

private:
    QSize sizeWith(const QString &text) const;
    QString brokenText(int width) const;
};

} // namespace codewheel
