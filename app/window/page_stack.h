// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayout>
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
    int heightForWidth(int width) const override
    {
        const int least = minimumSizeHint().height();
        const QLayout *parts = currentWidget() == nullptr ? nullptr : currentWidget()->layout();
        return parts != nullptr && parts->hasHeightForWidth()
                   ? std::max(least, parts->totalMinimumHeightForWidth(width))
                   : least;
    }

private:
    static int leastHeight(const QWidget &page)
    {
        return std::max(page.minimumSizeHint().height(), page.minimumHeight());
    }
};

} // namespace codewheel
