// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sequence/project_sequences.h"

#include "widgets/input/text_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/sequence/sequence_view.h"

#include <QComboBox>
#include <QLabel>
#include <QScopedValueRollback>
#include <QToolButton>

#include <algorithm>

namespace codewheel {

ProjectSequences::ProjectSequences(ProjectDocument &document, SequenceView &view, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_view(view)
    , m_names(named(new QComboBox(this), "sequenceName"))
    , m_add(describe(new QToolButton(this), "addSequence", tr("New sequence"), tr("Begins another sequence")))
    , m_remove(describe(new QToolButton(this), "removeSequence", tr("Remove the sequence"),
                        tr("Removes this sequence from the project; can be undone")))
    , m_holding(document.newGesture())
{
    m_names->setEditable(true);
    m_names->setInsertPolicy(QComboBox::NoInsert);
    auto *name = new TextField(m_names);
    m_names->setLineEdit(name);
    for (QWidget *field : {static_cast<QWidget *>(m_names), static_cast<QWidget *>(name)}) {
        describe(field, tr("Sequence of the project"),
                 tr("Chooses a sequence of the project; type to give it another name"));
    }
    m_add->setIcon(lineIcon(Icon::add));
    m_remove->setIcon(lineIcon(Icon::remove));
    for (QToolButton *button : {m_add, m_remove}) {
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
    }
    auto *label = new QLabel(tr("Se&quence"), this);
    label->setBuddy(m_names);
    layOutRow(this, {label, {m_names, 1}, m_add, m_remove},
              {.spacing = grid::unit, .margins = QMargins(grid::unit, grid::unit, grid::unit, 0)});

    connect(m_names, &QComboBox::activated, this, &ProjectSequences::open);
    connect(name, &TextField::taken, this, &ProjectSequences::rename);
    connect(m_add, &QToolButton::clicked, this, &ProjectSequences::add);
    connect(m_remove, &QToolButton::clicked, this, &ProjectSequences::remove);
    connect(&document, &ProjectDocument::changed, this, &ProjectSequences::take);
    connect(&view, &SequenceView::sendingEnded, this, &ProjectSequences::take);
    connect(&view, &SequenceView::listChanged, this, [this] {
        if (m_isTaking || std::exchange(m_isPending, true))
            return;
        QMetaObject::invokeMethod(this, &ProjectSequences::keep, Qt::QueuedConnection);
    });
    connect(
        &view, &SequenceView::holdTaken, this, [this] { m_holding = m_document.newGesture(); },
        Qt::QueuedConnection); // after keep(), which may be queued for earlier edits
    take();
}

// The focus lost in the destructor must not count as leaving the field.
ProjectSequences::~ProjectSequences()
{
    m_names->lineEdit()->disconnect(this);
}

void ProjectSequences::take()
{
    if (m_isTaking || m_view.isSending()) // what is being sent stays in sight
        return;
    const QScopedValueRollback taking(m_isTaking, true);
    const std::vector<ProjectSequence> &sequences = m_document.project().sequences;
    m_open = sequences.empty() ? 0 : std::min(m_open, sequences.size() - 1);
    QStringList names;
    for (const ProjectSequence &sequence : sequences)
        names << sequence.name;
    QStringList shown;
    for (int i = 0; i < m_names->count(); ++i)
        shown << m_names->itemText(i);
    if (names != shown) {
        m_names->clear();
        m_names->addItems(names);
    }
    m_names->setCurrentIndex(sequences.empty() ? -1 : static_cast<int>(m_open));
    m_names->setEnabled(!sequences.empty());
    m_remove->setEnabled(!sequences.empty());
    const WordList list = sequences.empty() ? WordList() : sequences[m_open].list;
    if (list != m_view.list())
        m_view.setList(list);
}

// Keeps what was edited in the view. The first words make the first sequence.
void ProjectSequences::keep()
{
    m_isPending = false;
    const WordList list = m_view.list();
    const std::vector<ProjectSequence> &sequences = m_document.project().sequences;
    if (sequences.empty() ? list == WordList() : sequences[m_open].list == list)
        return;
    const bool isHold = !sequences.empty() && sequences[m_open].list.words == list.words;
    edit(
        tr("Edit the sequence"),
        [&](std::vector<ProjectSequence> &changed) {
            if (changed.empty())
                changed.push_back({.name = freshName(), .list = {}});
            changed[m_open].list = list;
        },
        isHold ? m_holding : ProjectDocument::noGesture);
}

void ProjectSequences::open(int sequence)
{
    m_open = static_cast<std::size_t>(std::max(sequence, 0));
    take();
}

void ProjectSequences::add()
{
    const QString name = freshName();
    m_open = m_document.project().sequences.size();
    edit(tr("New sequence"),
         [&](std::vector<ProjectSequence> &sequences) { sequences.push_back({.name = name, .list = {}}); });
}

void ProjectSequences::remove()
{
    edit(tr("Remove the sequence"), [this](std::vector<ProjectSequence> &sequences) {
        if (m_open < sequences.size())
            sequences.erase(sequences.begin() + static_cast<std::ptrdiff_t>(m_open));
    });
}

// An empty name leaves the old one.
void ProjectSequences::rename(const QString &typed)
{
    const QString name = typed.trimmed();
    if (m_document.project().sequences.empty())
        return;
    if (name.isEmpty()) {
        m_names->setEditText(m_document.project().sequences.at(m_open).name);
        return;
    }
    edit(tr("Name the sequence"),
         [&](std::vector<ProjectSequence> &sequences) { sequences.at(m_open).name = name; });
}

void ProjectSequences::edit(const QString &what,
                            const std::function<void(std::vector<ProjectSequence> &)> &change,
                            ProjectDocument::Gesture gesture)
{
    Project after = m_document.project();
    change(after.sequences);
    m_document.edit(std::move(after), what, gesture);
}

QString ProjectSequences::freshName() const
{
    const std::vector<ProjectSequence> &sequences = m_document.project().sequences;
    for (int number = 1;; ++number) {
        QString name = tr("Sequence %1").arg(number);
        if (std::ranges::find(sequences, name, &ProjectSequence::name) == sequences.end())
            return name;
    }
}

} // namespace codewheel
