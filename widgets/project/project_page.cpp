// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/project/project_page.h"

#include "project/ring_plan.h"
#include "widgets/input/text_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/project/bus_list.h"

#include <QComboBox>
#include <QDir>
#include <QFormLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

namespace codewheel {
namespace {

constexpr int widestTitle = 140 * grid::unit;

} // namespace

ProjectPage::ProjectPage(ProjectDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_title(describe(new TextField(this), "projectTitle", tr("Title of the project"),
                       tr("Stands at the head of the commissioning report")))
    , m_link(describe(new QComboBox(this), "projectLink", tr("Link of the project"),
                      tr("The link the project is used with. Choosing one connects nothing.")))
    , m_settings(new QLabel(this))
    , m_buses(new BusList(document, this))
    , m_note(describe(new NoteField(this), "projectNote", tr("Note on the project"),
                      tr("What whoever opens the project next should know")))
    , m_file(new QLabel(this))
{
    makeFields();
    arrange();
    connect(m_title, &TextField::taken, this, &ProjectPage::setTitle);
    connect(m_link, &QComboBox::activated, this, &ProjectPage::setLink);
    connect(m_note, &NoteField::taken, this, &ProjectPage::setNote);
    connect(&m_document, &ProjectDocument::changed, this, &ProjectPage::showProject);
    connect(&m_document, &ProjectDocument::replaced, this, [this] {
        m_title->setText(m_document.project().title);
        m_note->setTakenText(m_document.project().note);
    });
    connect(&m_document, &ProjectDocument::fileChanged, this, &ProjectPage::showProject);
    showProject();
}

// Losing the focus by going is no leaving of a field.
ProjectPage::~ProjectPage()
{
    m_title->disconnect(this);
    m_note->disconnect(this);
}

void ProjectPage::makeFields()
{
    m_title->setPlaceholderText(tr("Crane 1"));
    m_title->setMaximumWidth(widestTitle);
    m_settings->setObjectName(QStringLiteral("linkSettings"));
    m_settings->setAccessibleName(tr("Settings of the link"));
    m_note->setPlaceholderText(tr("What whoever opens the project next should know"));
    m_file->setObjectName(QStringLiteral("projectFile"));
    for (QLabel *label : {m_settings, m_file}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
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
    form->addRow(tr("Lin&k"), m_link);
    form->addRow(QString(), m_settings);
    form->addRow(tr("B&uses"), m_buses);
    form->addRow(tr("&Note"), m_note);
    for (QWidget *field : {static_cast<QWidget *>(m_buses), static_cast<QWidget *>(m_note)})
        field->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    auto *area = new QScrollArea(this); // for low windows
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidgetResizable(true);
    area->setWidget(fields);
    auto *page = new QVBoxLayout(this);
    page->setContentsMargins({});
    page->addWidget(area);
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

// The settings are those of the link: another one has none of them.
void ProjectPage::setLink()
{
    const QString kind = m_link->currentData().toString();
    edit(tr("Link of the project"), [&](Project &project) {
        RingPlan plan = ringPlan(project, firstRing);
        if (plan.link.kind == kind)
            return;
        plan.link = {.kind = kind, .settings = {}};
        setRingPlan(project, firstRing, std::move(plan));
    });
}

// What is being typed stays while something else changes.
void ProjectPage::showProject()
{
    const Project &project = m_document.project();
    if (m_title->takenText() != project.title)
        m_title->setText(project.title);
    if (m_note->takenText() != project.note)
        m_note->setTakenText(project.note);
    m_file->setText(m_document.file().isEmpty() ? tr("not saved yet")
                                                : QDir::toNativeSeparators(m_document.file()));
    showLink();
}

// A project of another version or program may name a link that this one does not have: it is kept.
void ProjectPage::showLink()
{
    const ProjectLink &link = ringPlan(m_document.project(), firstRing).link;
    const QString training = ProjectLink().kind;
    m_link->clear();
    m_link->addItem(tr("Training bus"), training);
    if (link.kind != training)
        m_link->addItem(tr("%1 (this program has no such link)").arg(link.kind), link.kind);
    m_link->setCurrentIndex(m_link->findData(link.kind));
    QStringList settings;
    for (const auto &[name, value] : link.settings)
        settings << tr("%1: %2", "setting of a link, value").arg(name, value);
    m_settings->setText(settings.isEmpty() ? tr("It has no settings.") : settings.join(u'\n'));
}

} // namespace codewheel
