// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/setup/can_replace_steps.h"

#include "bus/buses.h"
#include "jobs/write_plan.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "widgets/kinds/canopen/setup/node_number_field.h"
#include "widgets/kinds/canopen/setup/node_setup_texts.h"
#include "widgets/kinds/canopen/setup/node_setup_view.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/project/project_document.h"

#include <QLabel>
#include <QPushButton>
#include <QRadioButton>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int usualNumberOfNew = 127;

int nodeOf(const Replacing &replacing)
{
    return CanopenAddress::of(replacing.place.node).node;
}

QString shownNode(const Replacing &replacing)
{
    return CanopenAddress{nodeOf(replacing)}.shown();
}

CanopenSession *canBusOf(const Replacing &replacing)
{
    return qobject_cast<CanopenSession *>(replacing.buses.busOf(replacing.place));
}

} // namespace

CanReplaceNumberStep::CanReplaceNumberStep(Replacing &replacing, QWidget *parent)
    : ReplaceStep(replacing, tr("Number"), parent)
    , m_about(wrappedLabel(this, "canReplaceAbout"))
    , m_isThere(describe(new QRadioButton(this), "canReplaceIsThere",
                         tr("It was given its number before, or has switches for it")))
    , m_hasOther(describe(new QRadioButton(tr("It has the nu&mber"), this), "canReplaceHasOther",
                          tr("As it was delivered: most makes come as node 127 or 1")))
    , m_hasNone(describe(new QRadioButton(tr("It has no number yet"), this), "canReplaceHasNone",
                         tr("It is looked for by LSS")))
    , m_number(describe(new NodeNumberField(this), "canReplaceNumber", tr("Number that it has"),
                        tr("The node number of the new encoder as it is now")))
    , m_view(new NodeSetupView(this))
{
    m_isThere->setText(sentence(tr("It has the number %1 already"), {shownNode(replacing)}));
    m_number->setValue(usualNumberOfNew);
    m_hasOther->setChecked(true);
    m_view->setReplacing(nodeOf(replacing));
    layOutColumn(this,
                 {m_about, layOutRow({m_hasOther, m_number, Stretch{1}}, {.spacing = grid::unit}), m_isThere,
                  m_hasNone, m_view, Stretch{1}},
                 {.spacing = grid::margin, .margins = QMargins()});
    setFocusProxy(m_number);
    for (QRadioButton *choice : {m_isThere, m_hasOther, m_hasNone})
        connect(choice, &QRadioButton::toggled, this, [this](bool isOn) {
            if (isOn)
                chooseDevice();
        });
    connect(m_number, &QSpinBox::valueChanged, this, &CanReplaceNumberStep::chooseDevice);
    connect(m_view, &NodeSetupView::changed, this, &CanReplaceNumberStep::takeSerial);
    connect(m_view, &NodeSetupView::changed, this, &ReplaceStep::changed);
    connect(m_view, &NodeSetupView::aboutToWrite, this, &ReplaceStep::givesPlace);
    connect(m_view, &NodeSetupView::numbered, this,
            [this](int before, int after) { m_hasGivenNumber = m_hasGivenNumber || before != after; });
    connect(m_view, &NodeSetupView::messaged, this, &CanReplaceNumberStep::messaged);
    chooseDevice();
}

void CanReplaceNumberStep::enter()
{
    m_about->setText(
        sentence(tr("Connect the new encoder, alone or beside the others, and switch it on. It gets the "
                    "number %1; the one that it replaces must not be on the bus any more. Two new ones with "
                    "the same number disturb each other: connect them one by one."),
                 {shownNode(m_replacing)}));
    m_view->setBus(canBusOf(m_replacing));
}

// What was found with its number already is not asked about again.
void CanReplaceNumberStep::chooseDevice()
{
    m_number->setEnabled(m_hasOther->isChecked());
    if (m_view->isBusy())
        return;
    m_view->setNode(m_hasNone->isChecked()   ? std::nullopt
                    : m_isThere->isChecked() ? std::optional(nodeOf(m_replacing))
                                             : std::optional(m_number->value()));
}

// Its label need not be typed where it tells its serial number.
void CanReplaceNumberStep::takeSerial()
{
    const auto &its = identity();
    if (its && its->serial() != 0 && m_replacing.now.serialNumber.isEmpty())
        m_replacing.now.serialNumber = QString::number(its->serial());
    for (QWidget *choice : {static_cast<QWidget *>(m_isThere), static_cast<QWidget *>(m_hasOther),
                            static_cast<QWidget *>(m_hasNone)})
        choice->setEnabled(!m_view->isBusy());
    m_number->setEnabled(m_hasOther->isChecked() && !m_view->isBusy());
}

bool CanReplaceNumberStep::mayGoOn() const
{
    return !m_view->isBusy() && identity() && (m_view->isFound() || m_view->node() == nodeOf(m_replacing));
}

bool CanReplaceNumberStep::isBusy() const
{
    return m_view->isBusy();
}

QString CanReplaceNumberStep::effect() const
{
    return tr("Gives the new encoder its number, after a question.");
}

QString CanReplaceNumberStep::doneSoFar() const
{
    return m_hasGivenNumber ? sentence(tr("The new encoder has got the number %1."), {shownNode(m_replacing)})
                            : QString();
}

const std::optional<canopen::NodeIdentity> &CanReplaceNumberStep::identity() const
{
    return m_view->identity();
}

CanReplaceProofStep::CanReplaceProofStep(Replacing &replacing, const CanReplaceNumberStep &number,
                                         QWidget *parent)
    : ReplaceStep(replacing, tr("Proof"), parent)
    , m_number(number)
    , m_result(wrappedLabel(this, "canReplaceProof"))
    , m_checkNow(describe(new QPushButton(lineIcon(Icon::search), tr("Check &it"), this), "canReplaceCheck",
                          tr("Looks for the encoder and reads its values, once its supply was switched off "
                             "and on (Alt+I)")))
{
    m_checkNow->setAutoDefault(false);
    layOutColumn(this, {m_result, layOutRow({m_checkNow, Stretch{1}}), Stretch{1}},
                 {.spacing = grid::margin, .margins = QMargins()});
    setFocusProxy(m_checkNow);
    connect(m_checkNow, &QPushButton::clicked, this, &CanReplaceProofStep::check);
    connect(&m_run, &NodeTaskRun::ended, this, &CanReplaceProofStep::takeChecked);
}

CanReplaceProofStep::~CanReplaceProofStep()
{
    m_run.disconnect(this);
    m_run.setBus(nullptr);
}

CanopenSession *CanReplaceProofStep::bus() const
{
    return canBusOf(m_replacing);
}

void CanReplaceProofStep::enter()
{
    const CanopenSession *connected = bus();
    m_bootUps = connected != nullptr ? canopen::BootUps::of(connected->latest(), nodeOf(m_replacing))
                                     : canopen::BootUps();
    m_result->setText(
        sentence(tr("Some makes say that they have stored, and do not. Switch the supply of the new encoder "
                    "off and on, then check it: as node %1 it has to tell its identity and the values that "
                    "were written."),
                 {shownNode(m_replacing)}));
}

void CanReplaceProofStep::check()
{
    CanopenSession *connected = bus();
    if (isBusy() || !m_number.identity() || connected == nullptr)
        return;
    m_checkNow->setEnabled(false);
    m_result->setText(tr("Looking for it."));
    m_check =
        std::make_unique<canopen::NodeCheck>(canopen::NodeCheck::Wanted{.node = nodeOf(m_replacing),
                                                                        .identity = *m_number.identity(),
                                                                        .nodeBefore = std::nullopt,
                                                                        .before = m_bootUps});
    m_run.setBus(connected);
    m_run.start(*m_check);
    Q_EMIT changed();
}

void CanReplaceProofStep::takeChecked()
{
    const QString refused = m_run.whyRefused() ? refusalText(*m_run.whyRefused()) + u' ' : QString();
    const bool isThere =
        m_check->result() == canopen::NodeCheck::Result::found && m_check->wasWithoutSupply();
    if (isThere)
        readValues();
    else
        end(refused + node_setup_text::end(*m_check, true));
}

ParameterValues CanReplaceProofStep::wanted() const
{
    ParameterValues values;
    const EncoderSession *encoder = m_replacing.buses.encoder(m_replacing.place);
    const ProjectDevice planned = m_replacing.project.device(m_replacing.place);
    for (const ParameterValue &value : planned.wanted) {
        const ParameterDescription *its =
            encoder != nullptr ? encoder->device().find(value.parameter) : nullptr;
        if (its != nullptr && its->canBeRead)
            values.push_back(value);
    }
    return values;
}

void CanReplaceProofStep::readValues()
{
    EncoderSession *encoder = m_replacing.buses.encoder(m_replacing.place);
    ReadParameters job;
    for (const ParameterValue &value : wanted())
        job.parameters.push_back(value.parameter);
    if (encoder == nullptr || job.parameters.empty()) {
        end(sentence(tr("Proven: it has begun anew, and is still node %1. There were no values to compare."),
                     {shownNode(m_replacing)}));
        return;
    }
    connect(
        encoder, &EncoderSession::finished, this, [this](const Outcome &outcome) { compare(outcome); },
        Qt::SingleShotConnection);
    m_isReading = true;
    if (const auto started = encoder->start(job); !started) {
        encoder->disconnect(this);
        end(refusalText(started.error()));
    }
}

void CanReplaceProofStep::compare(const Outcome &outcome)
{
    std::vector<Parameter> others;
    const ParameterValues all = wanted();
    for (const ParameterValue &value : all)
        if (const auto read = std::ranges::find(outcome.read, value.parameter, &ParameterValue::parameter);
            read == outcome.read.end() || read->value != value.value)
            others.push_back(value.parameter);
    if (!outcome.result)
        end(refusalText(outcome.result.error()));
    else if (others.empty())
        end(sentence(tr("Proven: it has begun anew, is still node %1, and has all values that were "
                        "written (%2)."),
                     {shownNode(m_replacing), QString::number(all.size())}));
    else
        end(sentence(tr("It is node %1, but these values are not as they were written: %2. It has not "
                        "stored them; write them again, and store them."),
                     {shownNode(m_replacing), parameterNames(others)}));
}

void CanReplaceProofStep::end(const QString &text)
{
    m_isReading = false;
    m_result->setText(text);
    m_checkNow->setEnabled(true);
    Q_EMIT changed();
}

QString CanReplaceProofStep::effect() const
{
    return tr("Reads only. Nothing is written.");
}

} // namespace codewheel
