// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/look/page_place.h"

#include <QMainWindow>
#include <QStackedWidget>

namespace codewheel {

void PagePlace::giveWay(QWidget *page)
{
    m_page = page;
    auto *pages = qobject_cast<QStackedWidget *>(parentWidget());
    if (const int index = pages != nullptr ? pages->indexOf(this) : -1; index >= 0) {
        const bool isChosen = pages->currentIndex() == index;
        pages->insertWidget(index, page);
        if (isChosen)
            pages->setCurrentWidget(page);
        pages->removeWidget(this);
    }
    hide();
}

void PagePlace::wantAll(const QMainWindow &window)
{
    for (auto *place : window.findChildren<PagePlace *>())
        Q_EMIT place->pageWanted();
}

} // namespace codewheel
