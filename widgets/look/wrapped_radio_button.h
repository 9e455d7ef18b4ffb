// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRadioButton>

namespace codewheel {

// A radio button whose text wraps between words.
class WrappedRadioButton final : public QRadioButton
{
    Q_OBJECT

public:
    explicit WrappedRadioButton(const QString &text, QWidget *parent = nullptr);

    QSize minimumSizeHint() const override; // fits the longest word
    int heightForWidth(int width) const override;

protected:
    void initStyleOption(QStyleOptionButton *option) const override;

private:
    QSize sizeWith(const QString &text) const;
    QString brokenText(int width) const;
};

} // namespace codewheel
