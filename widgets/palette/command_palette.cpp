// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/palette/command_palette.h"

#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/look/may_elide.h"
#include "widgets/look/on_event.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/palette/palette_delegate.h"
#include "widgets/palette/palette_model.h"

#include <QAccessible>
#include <QApplication>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMainWindow>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int mostRows = 10;      // in sight
constexpr int lettersInRow = 110; // of the average width
constexpr int gatherFor = 4;      // ms, then the window has its turn
constexpr int shareAbove = 10;    // of the height of the window

// ALARM STOP stays in reach.
int belowToolBars(const QWidget &window)
{
    const auto *main = qobject_cast<const QMainWindow *>(&window);
    return main == nullptr || main->centralWidget() == nullptr ? 0 : main->centralWidget()->y();
}

} // namespace

CommandPalette::CommandPalette(QWidget &window)
    : QFrame(&window)
    , m_window(window)
    , m_model(new PaletteModel(this))
    , m_field(describe(new QLineEdit(this), "paletteField", tr("Find a command"),
                       tr("Words in any order, or their beginnings: of an action, a device, a parameter, a "
                          "message or a page of the manual")))
    , m_list(describe(new QListView(this), "paletteList", tr("Commands found"),
                      tr("Return or a click carries it out")))
    , m_nothing(wrappedLabel(this, "paletteNothing"))
    , m_note(named(new QLabel(this), "paletteNote"))
{
    setObjectName(QStringLiteral("commandPalette"));
    setAccessibleName(tr("Command palette"));
    setFrameStyle(QFrame::Box | QFrame::Plain);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Window);
    m_field->setPlaceholderText(tr("Find a command, a device, a parameter, a message, a page of the manual"));
    m_field->setClearButtonEnabled(true);
    m_field->addAction(lineIcon(Icon::search), QLineEdit::LeadingPosition);
    m_field->installEventFilter(this);
    m_list->setModel(m_model);
    m_list->setItemDelegate(new PaletteDelegate(*m_model, m_list));
    m_list->setUniformItemSizes(true);
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setMouseTracking(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    allowEliding(*m_list);
    m_nothing->setMargin(grid::margin);
    m_nothing->setTextFormat(Qt::PlainText);
    m_note->setFont(textFont(TextSize::small));
    m_note->setForegroundRole(QPalette::PlaceholderText);
    layOutColumn(this, {m_field, {m_list, 1}, m_nothing, m_note}, {grid::unit, allAround(grid::margin)});
    m_gathering.setInterval(0);
    connect(&m_gathering, &QTimer::timeout, this, &CommandPalette::gather);
    connect(m_field, &QLineEdit::textChanged, this, &CommandPalette::filter);
    connect(m_list, &QListView::clicked, this, [this](const QModelIndex &index) { run(index.row()); });
    connect(qApp, &QApplication::focusChanged, this, [this](const QWidget *, const QWidget *now) {
        if (m_isOpen && now != nullptr && now->window() == &m_window && !isOurs(now))
            leave();
    });
    hide();
    onEvent(this, {QEvent::FontChange, QEvent::StyleChange},
            [this] { m_note->setFont(textFont(TextSize::small)); });
}

CommandPalette::~CommandPalette()
{
    qApp->removeEventFilter(this);
}

void CommandPalette::addSource(std::unique_ptr<PaletteSource> source)
{
    m_sources.push_back(std::move(source));
    m_source = m_sources.size();
}

void CommandPalette::setUsed(const QStringList &ids)
{
    m_model->setUsed(ids);
}

void CommandPalette::open()
{
    if (m_isOpen) {
        m_field->selectAll();
        return;
    }
    m_focusBefore.clear();
    for (QWidget *each = QApplication::focusWidget(); each != nullptr; each = each->parentWidget())
        m_focusBefore.emplace_back(each);
    m_isOpen = true;
    m_field->clear();
    for (const auto &source : m_sources)
        source->begin();
    m_source = 0;
    filter();
    gather();
    place();
    show();
    raise();
    m_window.activateWindow();
    m_field->setFocus(Qt::ShortcutFocusReason);
    qApp->installEventFilter(this);
    announce();
}

// A little at a time, so that the first rows are there at once, and typing is never held up.
void CommandPalette::gather()
{
    QElapsedTimer clock;
    clock.start();
    std::vector<PaletteEntry> entries;
    while (m_source < m_sources.size() && clock.elapsed() < gatherFor) {
        std::vector<PaletteEntry> part = m_sources[m_source]->next();
        if (part.empty())
            ++m_source;
        std::ranges::move(part, std::back_inserter(entries));
    }
    if (isComplete())
        m_gathering.stop();
    else if (!m_gathering.isActive())
        m_gathering.start();
    if (entries.empty())
        return;
    const int row = m_hasMoved ? m_list->currentIndex().row() : 0;
    m_model->add(std::move(entries));
    showFound();
    choose(row);
}

void CommandPalette::filter()
{
    m_hasMoved = false;
    m_model->setTyped(m_field->text());
    showFound();
    choose(0);
    announce();
}

void CommandPalette::showFound()
{
    const int found = m_model->rowCount();
    m_list->setVisible(found > 0);
    m_nothing->setVisible(found == 0);
    m_nothing->setText(m_model->words().isEmpty()
                           ? tr("Type what you are looking for.")
                           : tr("Nothing is found for \"%1\". Try fewer words, or the beginnings of words.")
                                 .arg(m_field->text().simplified()));
    m_note->setText(m_model->words().isEmpty() ? tr("What was used last, then what is used most")
                                               : tr("%n found", nullptr, found));
    place();
}

void CommandPalette::choose(int row)
{
    const int last = m_model->rowCount() - 1;
    m_list->setCurrentIndex(last < 0 ? QModelIndex() : m_model->index(std::clamp(row, 0, last)));
}

void CommandPalette::move(int by, bool isCircular)
{
    const int rows = m_model->rowCount();
    if (rows == 0)
        return;
    m_hasMoved = true;
    const int row = m_list->currentIndex().row() + by;
    choose(isCircular ? (row + rows) % rows : row);
    announce();
}

// The field keeps the focus, so a screen reader is told which row is chosen.
void CommandPalette::announce()
{
    const QModelIndex chosen = m_list->currentIndex();
    const QString what =
        chosen.isValid() ? chosen.data(Qt::AccessibleTextRole).toString() : m_nothing->text();
    m_field->setAccessibleDescription(what);
    if (!m_isOpen || !chosen.isValid())
        return;
    QAccessibleEvent event(m_list, QAccessible::Focus);
    event.setChild(chosen.row());
    QAccessible::updateAccessibility(&event);
}

void CommandPalette::run(int row)
{
    if (row < 0 || row >= m_model->rowCount())
        return;
    const PaletteEntry entry = m_model->entry(row); // the rows go with the palette
    if (entry.state && !entry.state().isEnabled)
        return;
    close();
    if (!entry.id.isEmpty())
        Q_EMIT used(entry.id);
    entry.run();
}

// The focus returns first: what is carried out may apply to what has it.
void CommandPalette::close()
{
    if (!m_isOpen)
        return;
    m_isOpen = false;
    const auto before = std::ranges::find_if(m_focusBefore, [](const auto &each) {
        return each && each->isVisible() && each->focusPolicy() != Qt::NoFocus;
    });
    if (before != m_focusBefore.end())
        (*before)->setFocus(Qt::OtherFocusReason);
    leave();
}

void CommandPalette::leave()
{
    m_isOpen = false;
    qApp->removeEventFilter(this);
    m_gathering.stop();
    m_source = m_sources.size();
    hide();
    m_model->clear();
}

bool CommandPalette::takeKey(int key, Qt::KeyboardModifiers modifiers)
{
    const int page = std::max(1, m_list->height() / PaletteDelegate::rowHeight(*m_list) - 1);
    switch (key) {
    case Qt::Key_Up:
    case Qt::Key_Backtab:
        move(-1, true);
        return true;
    case Qt::Key_Down:
    case Qt::Key_Tab:
        move(1, true);
        return true;
    case Qt::Key_PageUp:
        move(-page, false);
        return true;
    case Qt::Key_PageDown:
        move(page, false);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if ((modifiers & ~Qt::KeypadModifier) == Qt::NoModifier)
            run(m_list->currentIndex().row());
        return true;
    case Qt::Key_Escape:
        close();
        return true;
    default:
        return false;
    }
}

bool CommandPalette::isOurs(const QObject *object) const
{
    const auto *widget = qobject_cast<const QWidget *>(object);
    return widget != nullptr && (widget == this || isAncestorOf(widget));
}

bool CommandPalette::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_field && event->type() == QEvent::KeyPress) {
        const auto *key = static_cast<QKeyEvent *>(event);
        return takeKey(key->key(), key->modifiers());
    }
    if (watched == &m_window && event->type() == QEvent::Resize)
        place();
    if (event->type() == QEvent::MouseButtonPress && qobject_cast<QWidget *>(watched) != nullptr &&
        !isOurs(watched) && QApplication::activePopupWidget() == nullptr)
        close(); // the click goes where it was meant to go
    return QFrame::eventFilter(watched, event);
}

// Over the middle of the window, as high as its rows need.
void CommandPalette::place()
{
    if (!m_isOpen)
        return;
    const int width =
        std::min(lettersInRow * fontMetrics().averageCharWidth(), m_window.width() - 4 * grid::margin);
    const int top = std::max(m_window.height() / shareAbove, belowToolBars(m_window));
    const int line = PaletteDelegate::rowHeight(*m_list);
    const int around = m_field->sizeHint().height() + m_note->sizeHint().height() + 2 * grid::unit +
                       2 * (grid::margin + frameWidth());
    const int mostHere = std::max(1, (m_window.height() - top - around - grid::margin) / line);
    m_list->setFixedHeight(std::clamp(m_model->rowCount(), 1, std::min(mostRows, mostHere)) * line);
    layout()->activate();
    const int height = layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width)
                                                     : layout()->totalSizeHint().height();
    setGeometry((m_window.width() - width) / 2, top, width, height);
}

} // namespace codewheel
