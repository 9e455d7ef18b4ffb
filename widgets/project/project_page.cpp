// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/project/project_page.h"

#include "widgets/input/text_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/project/bus_list.h"

#include <QDir>
#include <QFormLayout>
#include <QScrollArea>

namespace codewheel {
namespace {

constexpr int widestTitle = 140 * grid::unit;

} // namespace

ProjectPage::ProjectPage(ProjectDocument &document, QWidget *parent)
    : Page(parent)
    , m_document(document)
    , m_title(describe(new TextField(this), "projectTitle", tr("Title of the project"),
                       tr("The heading of the commissioning report")))
    , m_buses(new BusList(document, this))
    , m_note(describe(new NoteField(this), "projectNote", tr("Note on the project"),
                      tr("What the next person to open the project should know")))
    , m_file(wrappedLabel(this, "projectFile"))
{
    makeFields();
    arrange();
    connect(m_title, &TextField::taken, this, &ProjectPage::setTitle);
    connect(m_note, &NoteField::taken, this, &ProjectPage::setNote);
    connect(&m_document, &ProjectDocument::changed, this, &ProjectPage::showProject);
    connect(&m_document, &ProjectDocument::replaced, this, [this] {
        m_title->setText(m_document.project().title);
        m_note->setTakenText(m_document.project().note);
    });
    connect(&m_document, &ProjectDocument::fileChanged, this, &ProjectPage::showProject);
    showProject();
}

// The focus lost in the destructor must not count as leaving a field.
ProjectPage::~ProjectPage()
{
    m_title->disconnect(this);
    m_note->disconnect(this);
}

QString ProjectPage::effect() const
{
    return tr("Edits title and note of the project, and its list of buses. Nothing is sent here.");
}

void ProjectPage::makeFields()
{
    m_title->setPlaceholderText(tr("Crane 1"));
    m_title->setMaximumWidth(widestTitle);
    m_note->setPlaceholderText(tr("What the next person to open the project should know"));
    m_file->setTextFormat(Qt::PlainText);
    m_file->setTextInteractionFlags(Qt::TextSelectableByMouse);
    setFocusProxy(m_title);
}

void ProjectPage::arrange()
{
    auto *fields = new QWidget;
    auto *form = new QFormLayout(fields);
    form->setContentsMargins(grid::margin, grid::margin, grid::margin, grid::margin);
    form->setHorizontalSpacing(2 * grid::groupGap);
    form->setVerticalSpacing(grid::margin);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(tr("&Title"), m_title);
    form->addRow(tr("File"), m_file);
    form->addRow(tr("B&uses"), m_buses);
    form->addRow(tr("&Note"), m_note);
    for (QWidget *field : {static_cast<QWidget *>(m_buses), static_cast<QWidget *>(m_note)})
        field->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    auto *area = new QScrollArea(this); // for low windows
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidgetResizable(true);
    area->setWidget(fields);
    layOutColumn(this, {area}, {.margins = QMargins()});
}

void ProjectPage::edit(const QString &what, const std::function<void(Project &)> &change)
{
    Project after = m_document.project();
    change(after);
    m_document.edit(std::move(after), what);
}

void ProjectPage::setTitle(const QString &title)
{
    edit(tr("Title of the project"), [&](Project &project) { project.title = title; });
}

void ProjectPage::setNote(const QString &note)
{
    edit(tr("Note on the project"), [&](Project &project) { project.note = note; });
}

// What is being typed stays when something else changes.
void ProjectPage::showProject()
{
    const Project &project = m_document.project();
    if (m_title->takenText() != project.title)
        m_title->setText(project.title);
    if (m_note->takenText() != project.note)
        m_note->setTakenText(project.note);
    m_file->setText(m_document.file().isEmpty() ? tr("not saved yet")
                                                : QDir::toNativeSeparators(m_document.file()));
    Q_EMIT headChanged();
}

} // namespace codewheel
