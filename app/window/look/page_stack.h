// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStackedWidget>

#include <algorithm>

namespace codewheel {

// The pages in the middle of the window, which needs the height of the one that is shown, not of the highest.
class PageStack : public QStackedWidget
{
public:
    using QStackedWidget::QStackedWidget;

    QSize minimumSizeHint() const override
    {
        const QSize least = QStackedWidget::minimumSizeHint();
        return {least.width(), currentWidget() == nullptr ? least.height() : leastHeight(*currentWidget())};
    }
    int heightForWidth(int) const override { return minimumSizeHint().height(); }

private:
    static int leastHeight(const QWidget &page)
    {
        return std::max(page.minimumSizeHint().height(), page.minimumHeight());
    }
};

} // namespace codewheel
