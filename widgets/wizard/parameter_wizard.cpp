// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/parameter_wizard.h"

#include "bus/buses.h"
#include "widgets/job/step_list.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/look/on_event.h"
#include "widgets/models/shown_encoder.h"
#include "widgets/wizard/device_page.h"
#include "widgets/wizard/direction_page.h"
#include "widgets/wizard/handshake_page.h"
#include "widgets/wizard/known_page.h"
#include "widgets/wizard/report_page.h"
#include "widgets/wizard/review_page.h"
#include "widgets/wizard/values_page.h"

#include <QLabel>
#include <QLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int wizardStepsFrom = 680; // logical pixels

// With the widest of the texts it has in turn, so that the button beside it stays in its place.
int widthOfNext(const QPushButton &next, const std::vector<WizardPage *> &pages)
{
    QPushButton button(next.icon(), {}, next.parentWidget());
    int width = 0;
    for (const WizardPage *page : pages) {
        button.setText(page->nextText());
        width = std::max(width, button.sizeHint().width());
    }
    return width;
}

} // namespace

ParameterWizard::ParameterWizard(Buses &buses, WantedValues &wanted, QWidget *parent)
    : codewheel::Page(parent)
    , m_setup(new Setup{.buses = &buses, .encoder = {}, .wanted = wanted, .wish = {}, .record = {}})
    , m_stepName(new QLabel(this))
    , m_pages(new QStackedWidget(this))
    , m_cancel(describe(new QPushButton(lineIcon(Icon::cancel), tr("Cance&l"), this), "wizardCancel",
                        tr("Undoes what was set here, and leaves the wizard. During a handshake it first "
                           "asks in which state to leave the encoder.")))
    , m_back(describe(new QPushButton(lineIcon(Icon::back), tr("Bac&k"), this), "wizardBack",
                      tr("To the previous page.")))
    , m_next(named(new QPushButton(lineIcon(Icon::next), tr("&Next"), this), "wizardNext"))
{
    makePages();
    QStringList titles;
    for (const WizardPage *page : m_all)
        titles.append(page->title());
    m_stepList = new StepList(titles, this);

    layOutRow(
        this,
        {m_stepList,
         {layOutColumn({m_stepName, {m_pages, 1}, layOutRow({m_cancel, Stretch{}, m_back, m_next})}), 1}},
        {.margins = allAround(grid::margin)});

    connect(m_cancel, &QPushButton::clicked, this, &ParameterWizard::cancel);
    connect(m_back, &QPushButton::clicked, this, &ParameterWizard::back);
    connect(m_next, &QPushButton::clicked, this, &ParameterWizard::next);
    connect(&buses, &Buses::changed, this, [this] {
        if (page() == device) // the encoders may have changed
            m_devicePage->enter();
    });
    connect(&wanted, &WantedValues::changed, this, [this] { m_setup->takeWanted(); });
    showPage(device);
    onEvent(this, {QEvent::Resize}, [this] {
        m_stepList->setVisible(width() >= wizardStepsFrom);
        m_stepName->setVisible(width() < wizardStepsFrom);
    });
}

// The pages are destroyed before what they share: a field that loses the focus would still take its value.
ParameterWizard::~ParameterWizard()
{
    delete m_pages;
}

void ParameterWizard::makePages()
{
    m_devicePage = new DevicePage(*m_setup);
    m_handshakePage = new HandshakePage(*m_setup);
    m_all = {m_devicePage,
             new KnownPage(*m_setup),
             new DirectionPage(*m_setup),
             new ValuesPage(*m_setup),
             new ReviewPage(*m_setup),
             m_handshakePage,
             new ReportPage(*m_setup)};
    for (WizardPage *page : m_all) {
        auto *scroll = new QScrollArea(m_pages);
        scroll->setFrameShape(QFrame::NoFrame);
        scroll->setWidgetResizable(true);
        scroll->setFocusPolicy(Qt::NoFocus);
        scroll->setWidget(page);
        page->layout()->setContentsMargins({}); // flush with the title and the buttons
        m_pages->addWidget(scroll);
        connect(page, &WizardPage::changed, this, &ParameterWizard::showButtons);
    }
    connect(m_devicePage, &DevicePage::encoderChosen, this, &ParameterWizard::choose);
    connect(m_handshakePage, &HandshakePage::goesOn, this, &ParameterWizard::goesOn);
    connect(m_handshakePage, &WizardPage::changed, this, &ParameterWizard::headChanged);
}

EncoderSession *ParameterWizard::encoder() const
{
    return m_setup->encoder;
}

void ParameterWizard::setEncoder(EncoderSession *encoder)
{
    m_chosen = encoder;
    const bool isUnderWay = page() != device && m_setup->encoder;
    if (!isUnderWay && encoder != m_setup->encoder)
        beginAnew();
}

void ParameterWizard::beginAnew()
{
    follow(m_chosen);
    showPage(device);
}

void ParameterWizard::choose(EncoderSession *encoder)
{
    m_chosen = encoder;
    follow(encoder);
    Q_EMIT encoderChosen(encoder->place());
}

void ParameterWizard::follow(EncoderSession *encoder)
{
    if (m_setup->encoder)
        m_setup->encoder->disconnect(this);
    m_setup->encoder = encoder;
    m_setup->wish = {};
    m_setup->byHand = true;
    m_setup->hasChosenPosition = false;
    m_setup->takeWanted();
    m_setup->keep();
    m_setup->record = {};
    Q_EMIT headChanged();
    if (encoder == nullptr)
        return;
    connect(encoder, &EncoderSession::latestChanged, this, [this] { current()->showLatest(); });
    connect(encoder, &EncoderSession::freshnessChanged, this, [this] { current()->showLatest(); });
    connect(encoder, &EncoderSession::knownChanged, this, [this] { current()->showKnown(); });
    connect(encoder, &EncoderSession::permissionChanged, this, [this] { current()->showPermission(); });
    connect(encoder, &EncoderSession::progressed, this, &ParameterWizard::takeProgress);
    connect(encoder, &EncoderSession::finished, this, &ParameterWizard::takeOutcome);
    connect(encoder, &EncoderSession::exchanged, this, &ParameterWizard::takeRow);
    connect(encoder, &QObject::destroyed, this, [this] { showPage(device); });
}

ParameterWizard::UnderWay ParameterWizard::takeUnderWay()
{
    UnderWay now{.encoder = m_setup->encoder,
                 .wish = m_setup->wish,
                 .given = m_setup->given,
                 .byHand = m_setup->byHand,
                 .hasChosenPosition = m_setup->hasChosenPosition,
                 .record = m_setup->record,
                 .handshake = m_handshakePage->underWay(),
                 .page = page()};
    m_setup->keep(); // it is not undone: the other one goes on
    return now;
}

void ParameterWizard::goOn(const UnderWay &before)
{
    if (!before.encoder)
        return;
    follow(before.encoder);
    m_setup->wish = before.wish;
    m_setup->given = before.given;
    m_setup->byHand = before.byHand;
    m_setup->hasChosenPosition = before.hasChosenPosition;
    m_setup->record = before.record;
    showPage(before.page);
    if (before.page == handshake || before.page == report)
        m_handshakePage->resume(before.handshake);
}

void ParameterWizard::focusPage()
{
    current()->setFocus();
}

bool ParameterWizard::isBusy() const
{
    return m_handshakePage->isBusy();
}

ParameterWizard::Page ParameterWizard::page() const
{
    return static_cast<Page>(m_pages->currentIndex());
}

WizardPage *ParameterWizard::current() const
{
    return m_all[static_cast<std::size_t>(m_pages->currentIndex())];
}

// The focus stays where it is while the user chooses encoders elsewhere.
void ParameterWizard::showPage(int page)
{
    const QWidget *focus = window()->focusWidget();
    const bool isElsewhere = focus != nullptr && !isAncestorOf(focus);
    m_pages->setCurrentIndex(page);
    m_press.begin();
    m_stepList->setCurrent(page);
    m_next->setMinimumWidth(widthOfNext(*m_next, m_all));
    if (m_setup->encoder || page == device)
        current()->enter();
    showButtons();
    m_stepName->setText(current()->title());
    Q_EMIT headChanged();
    if (!isElsewhere)
        current()->setFocus();
}

void ParameterWizard::next()
{
    if (page() == report) {
        beginAnew();
        Q_EMIT closeRequested();
        return;
    }
    const bool starts = page() == review;
    if ((starts || page() == handshake) && m_press.isSecond())
        return;
    current()->leave();
    if (!current()->mayGoOn())
        return;
    if (starts)
        m_setup->keep();
    showPage(page() + 1);
    if (starts)
        m_handshakePage->start();
}

void ParameterWizard::back()
{
    current()->leave();
    showPage(page() == report ? int(values) : page() == handshake ? int(review) : page() - 1);
}

void ParameterWizard::cancel()
{
    if (isBusy()) {
        m_handshakePage->cancel();
        return;
    }
    m_setup->takeBack();
    beginAnew();
    Q_EMIT closeRequested();
}

QString ParameterWizard::title() const
{
    return tr("Parameter wizard %1/%2", "step of steps").arg(page() + 1).arg(pageCount);
}

QString ParameterWizard::about() const
{
    if (!m_setup->encoder)
        return {};
    const Place place = m_setup->encoder->place();
    return calledInFull(place, m_stationOf(place), m_setup->encoder->device());
}

QString ParameterWizard::effect() const
{
    if (page() < handshake)
        return tr("Edits wanted values of the project; nothing is sent before the handshake.");
    if (page() == report)
        return tr("Nothing is sent here.");
    return m_handshakePage->waitsForFirstStep() ? tr("Nothing is sent before the first step.")
           : isBusy()                           ? tr("Writes to the encoder.")
                                                : tr("Nothing is being sent.");
}

QString ParameterWizard::lostByClosing() const
{
    if (isBusy())
        return tr("The handshake is under way: until it has ended, the encoder may give no position.") +
               u' ' + codewheel::Page::goesOn() + u' ' + tr("Wizard shows it again.");
    const QStringList changed = m_setup->encoder ? m_setup->changed() : QStringList();
    return changed.isEmpty()
               ? QString()
               : tr("What was set in the wizard is undone: %1.").arg(changed.join(QStringLiteral(", ")));
}

void ParameterWizard::leave()
{
    if (isBusy())
        return;
    m_setup->takeBack();
    beginAnew();
}

void ParameterWizard::showButtons()
{
    m_next->setText(current()->nextText());
    m_next->setEnabled(current()->mayGoOn());
    m_next->setToolTip(page() == review ? tr("Sends the steps above to the encoder.")
                                        : tr("To the next page."));
    m_back->setEnabled(page() > device && current()->mayGoBack());
    m_cancel->setVisible(page() != report);
    if (page() == handshake && current()->mayGoOn())
        m_next->setFocus();
}

void ParameterWizard::takeProgress(const Progress &progress)
{
    m_setup->record.progress = progress;
    current()->showProgress();
    Q_EMIT headChanged(); // the first step may have been sent
}

void ParameterWizard::takeOutcome(const Outcome &outcome)
{
    m_handshakePage->showOutcome(outcome);
    if (current() != m_handshakePage)
        current()->showOutcome(outcome);
}

void ParameterWizard::takeRow(const Exchange &row)
{
    if (isBusy())
        m_setup->record.rows.push_back(row);
    m_handshakePage->showRow(row);
}

} // namespace codewheel
