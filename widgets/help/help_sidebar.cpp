// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/help_sidebar.h"

#include "widgets/help/manual.h"
#include "widgets/help/manual_search.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QScopedValueRollback>
#include <QStackedWidget>
#include <QTreeWidget>

namespace codewheel {
namespace {

constexpr int urlOfRow = Qt::UserRole;

QTreeWidgetItem *addRow(QTreeWidgetItem *parent, const QString &title, const QUrl &url)
{
    auto *row = new QTreeWidgetItem(parent, {title});
    row->setData(0, urlOfRow, url);
    row->setToolTip(0, title);
    return row;
}

void addPage(QTreeWidgetItem *parent, const ManualPage &page)
{
    QTreeWidgetItem *row = addRow(parent, page.title, page.url);
    for (const ManualSection &section : page.sections)
        if (section.level == 2) {
            QUrl url = page.url;
            url.setFragment(section.anchor);
            addRow(row, section.title, url);
        }
}

} // namespace

HelpSidebar::HelpSidebar(const Manual &manual, QWidget *parent)
    : QWidget(parent)
    , m_manual(manual)
    , m_search(describe(new QLineEdit(this), "helpSearch", tr("Search the manual"),
                        tr("Searches all pages for sections that have all these words (Ctrl+Shift+F)")))
    , m_stack(new QStackedWidget(this))
    , m_contents(makeContents())
    , m_hits(describe(new QListWidget(this), "helpHits", tr("Sections found"),
                      tr("Sections of the manual that have all words searched for")))
    , m_count(wrappedLabel(this, "helpHitCount"))
{
    m_search->setPlaceholderText(tr("Search the manual"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(lineIcon(Icon::search), QLineEdit::LeadingPosition);
    m_search->installEventFilter(this);
    m_hits->setWordWrap(true);
    m_hits->setSpacing(grid::unit / 2);
    m_hits->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *found = new QWidget(this);
    layOutColumn(found, {m_count, {m_hits, 1}}, {grid::unit, allAround(0)});
    m_stack->addWidget(m_contents);
    m_stack->addWidget(found);
    layOutColumn(this, {m_search, {m_stack, 1}}, {grid::unit, allAround(grid::unit)});

    connect(m_search, &QLineEdit::textChanged, this, &HelpSidebar::search);
    connect(m_contents, &QTreeWidget::currentItemChanged, this,
            [this](QTreeWidgetItem *item) { open(item); });
    connect(m_contents, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem *item) { open(item); });
    connect(m_hits, &QListWidget::currentItemChanged, this, [this](QListWidgetItem *item) { open(item); });
    connect(m_hits, &QListWidget::itemClicked, this, [this](QListWidgetItem *item) { open(item); });
}

QTreeWidget *HelpSidebar::makeContents()
{
    auto *tree = describe(new QTreeWidget(this), "helpContents", tr("Contents"),
                          tr("Pages of the manual and their sections"));
    tree->setHeaderHidden(true);
    tree->setUniformRowHeights(true);
    auto *others = new QTreeWidgetItem({tr("Files and protocols")});
    others->setFlags(Qt::ItemIsEnabled);
    for (const ManualPage &page : m_manual.pages())
        addPage(page.isOfManual ? tree->invisibleRootItem() : others, page);
    tree->addTopLevelItem(others);
    return tree;
}

void HelpSidebar::focusSearch()
{
    m_search->setFocus(Qt::ShortcutFocusReason);
    m_search->selectAll();
}

void HelpSidebar::endSearch()
{
    m_search->clear();
}

QStringList HelpSidebar::words() const
{
    return searchedWords(m_search->text());
}

void HelpSidebar::search()
{
    const QStringList words = this->words();
    showHits(searchManual(m_manual, words));
    m_stack->setCurrentIndex(words.isEmpty() ? 0 : 1);
    Q_EMIT wordsChanged();
}

void HelpSidebar::showHits(const std::vector<ManualHit> &hits)
{
    const QScopedValueRollback showing(m_isShowing, true);
    m_hits->clear();
    for (const ManualHit &hit : hits) {
        const QString head =
            hit.page == hit.section ? hit.page : QStringLiteral("%1: %2").arg(hit.page, hit.section);
        auto *row = new QListWidgetItem(head + u'\n' + hit.excerpt, m_hits);
        row->setData(urlOfRow, hit.url);
        row->setToolTip(head);
    }
    m_count->setText(hits.empty() ? tr("No section of the manual has all these words.")
                                  : tr("%n sections", nullptr, static_cast<int>(hits.size())));
}

void HelpSidebar::open(QTreeWidgetItem *item)
{
    if (item != nullptr && !m_isShowing && item->data(0, urlOfRow).isValid())
        Q_EMIT chosen(item->data(0, urlOfRow).toUrl());
}

void HelpSidebar::open(QListWidgetItem *item)
{
    if (item != nullptr && !m_isShowing)
        Q_EMIT chosen(item->data(urlOfRow).toUrl());
}

// The row of the section, or of the page if the contents have no such row.
void HelpSidebar::showWhere(const QUrl &url)
{
    const QScopedValueRollback showing(m_isShowing, true);
    QTreeWidgetItem *best = nullptr;
    for (QTreeWidgetItemIterator each(m_contents); *each != nullptr; ++each) {
        const QUrl its = (*each)->data(0, urlOfRow).toUrl();
        if (its == url || its == url.adjusted(QUrl::RemoveFragment))
            best = *each;
        if (its == url)
            break;
    }
    m_contents->setCurrentItem(best);
    if (best != nullptr)
        m_contents->scrollToItem(best);
}

// From the search field into the results by keyboard.
bool HelpSidebar::eventFilter(QObject *watched, QEvent *event)
{
    if (watched != m_search || event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    const auto *key = static_cast<QKeyEvent *>(event);
    const bool isEnter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
    if (key->key() == Qt::Key_Escape && !m_search->text().isEmpty()) {
        endSearch();
        return true;
    }
    if (!isEnter && key->key() != Qt::Key_Down)
        return false;
    if (m_stack->currentIndex() == 0) {
        m_contents->setFocus();
    } else if (m_hits->count() > 0) {
        m_hits->setFocus();
        m_hits->setCurrentRow(0);
    }
    return true;
}

} // namespace codewheel
