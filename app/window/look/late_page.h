// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/help/help_topic.h"

#include <QStackedWidget>

#include <functional>
#include <utility>

namespace codewheel {

// A page of the window that is made when it is first needed, because most people do not need it on most days.
// It has its place in the stack from the start, so the pages behind it keep theirs. A page
// with keys of its own has to be made before they are listed.
template <typename Page>
class LatePage
{
public:
    LatePage(QStackedWidget &pages, const char *helpTopic, std::function<Page *()> make)
        : m_pages(pages)
        , m_helpTopic(helpTopic)
        , m_place(new QWidget(&pages))
        , m_make(std::move(make))
    {
        setHelpTopic(*m_place, m_helpTopic);
        pages.addWidget(m_place);
    }

    Page *ifMade() const { return m_page; } // null: not yet

    Page &page()
    {
        if (m_page == nullptr) {
            m_page = m_make();
            setHelpTopic(*m_page, m_helpTopic);
            m_pages.insertWidget(m_pages.indexOf(m_place), m_page);
            m_pages.removeWidget(m_place);
            delete std::exchange(m_place, nullptr);
        }
        return *m_page;
    }

private:
    QStackedWidget &m_pages;
    const char *const m_helpTopic;
    QWidget *m_place;
    Page *m_page = nullptr;
    const std::function<Page *()> m_make;
};

} // namespace codewheel
