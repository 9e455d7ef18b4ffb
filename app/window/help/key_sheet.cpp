// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/help/key_sheet.h"

#include "app/window/help/key_list.h"
#include "widgets/help/help_topic.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"

#include <QHeaderView>
#include <QLineEdit>
#include <QMainWindow>
#include <QTreeWidget>

namespace codewheel {
namespace {

constexpr int lettersInLine = 72;
constexpr int sheetHeight = 560; // fits the smallest window; the rest scrolls
constexpr auto sheetName = "keys";

QTreeWidgetItem *groupRow(const QString &title)
{
    auto *row = new QTreeWidgetItem({title});
    row->setFirstColumnSpanned(true);
    QFont strong = row->font(0);
    strong.setBold(true);
    row->setFont(0, strong);
    return row;
}

} // namespace

// A tool window leaves its parent's keys working, including ALARM STOP.
KeySheet::KeySheet(QMainWindow &window)
    : QDialog(&window, Qt::Tool)
    , m_search(describe(new QLineEdit(this), "keySearch", tr("Search the keys"),
                        tr("Leaves the keys that do this, or have this name")))
    , m_keys(describe(new QTreeWidget(this), "keyList", tr("Keys"),
                      tr("All keys, by the menu or the part of the window in which they work")))
{
    setObjectName(QLatin1String(sheetName));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Keys"));
    setHelpTopic(*this, "help.md#keys");
    m_search->setPlaceholderText(tr("Search the keys"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(lineIcon(Icon::search), QLineEdit::LeadingPosition);
    m_keys->setHeaderLabels({tr("What it does"), tr("Key")});
    m_keys->setUniformRowHeights(true);
    m_keys->header()->setStretchLastSection(false);
    m_keys->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_keys->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    layOutColumn(this, {m_search, {m_keys, 1}}, {grid::margin, allAround(grid::margin)});
    fill(window);
    connect(m_search, &QLineEdit::textChanged, this, &KeySheet::filter);
    resize(lettersInLine * fontMetrics().averageCharWidth(), sheetHeight);
}

void KeySheet::show(QMainWindow &window)
{
    auto *sheet = window.findChild<KeySheet *>(QLatin1String(sheetName));
    if (sheet == nullptr)
        sheet = new KeySheet(window);
    sheet->setVisible(true);
    sheet->raise();
    sheet->activateWindow();
    sheet->m_search->setFocus();
    sheet->m_search->selectAll();
}

void KeySheet::fill(const QMainWindow &window)
{
    for (const KeyGroup &group : keysOf(window)) {
        QTreeWidgetItem *head = groupRow(group.title);
        m_keys->addTopLevelItem(head);
        head->setFirstColumnSpanned(true);
        for (const KeyHelp &key : group.rows) {
            auto *row = new QTreeWidgetItem(head, {key.what, key.keys});
            row->setToolTip(0, key.what);
        }
    }
    m_keys->expandAll();
}

// A group whose title matches is shown as a whole.
void KeySheet::filter()
{
    const QString text = m_search->text().simplified();
    const auto has = [&text](const QTreeWidgetItem &row) {
        return row.text(0).contains(text, Qt::CaseInsensitive) ||
               row.text(1).contains(text, Qt::CaseInsensitive);
    };
    for (int i = 0; i < m_keys->topLevelItemCount(); ++i) {
        QTreeWidgetItem *group = m_keys->topLevelItem(i);
        const bool isWhole = has(*group);
        bool isAny = isWhole;
        for (int j = 0; j < group->childCount(); ++j) {
            const bool isShown = isWhole || has(*group->child(j));
            group->child(j)->setHidden(!isShown);
            isAny |= isShown;
        }
        group->setHidden(!isAny);
    }
}

} // namespace codewheel
