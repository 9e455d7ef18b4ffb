// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/offer/offer_page.h"

#include "widgets/input/form_fields.h"
#include "widgets/kinds/interbus/offer/offer_form.h"
#include "widgets/kinds/interbus/offer/offered_view.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"

#include <QPushButton>
#include <QStackedWidget>

#include <utility>

namespace codewheel {
namespace {

constexpr int widestForm = 180 * grid::unit; // in a wide window fields stay near their labels

} // namespace

OfferPage::OfferPage(QWidget *parent)
    : Page(parent)
    , m_form(new OfferForm(this))
    , m_offered(new OfferedView(this))
    , m_parts(new QStackedWidget(this))
    , m_problem(new InlineMessage(this))
    , m_offer(describe(new QPushButton(lineIcon(Icon::start), tr("&Offer"), this), "offer", QString()))
    , m_end(describe(new QPushButton(lineIcon(Icon::stop), tr("&Stop offering"), this), "stopOffering",
                     tr("Disconnects all clients (Alt+S)")))
    , m_files(describe(new QPushButton(lineIcon(Icon::save), QString(), this), "clientFiles",
                       tr("Projects with which a Codewheel at another seat connects to its ring (Alt+I)")))
{
    setAccessibleName(title());
    auto *narrow = new QWidget(this);
    m_form->setMaximumWidth(widestForm);
    layOutColumn(narrow, {m_form, Stretch{1}}, {.margins = QMargins()});
    m_parts->addWidget(narrow);
    m_parts->addWidget(m_offered);
    for (QPushButton *button : {m_offer, m_end, m_files})
        button->setAutoDefault(false);
    connect(m_form, &OfferForm::edited, m_problem, &InlineMessage::withdraw);
    connect(m_offer, &QPushButton::clicked, this, &OfferPage::offer);
    connect(m_end, &QPushButton::clicked, this, &OfferPage::endWanted);
    connect(m_files, &QPushButton::clicked, this, &OfferPage::filesWanted);
    layOutColumn(this, {{m_parts, 1}, m_problem, layOutRow({m_files, Stretch{1}, m_offer, m_end})},
                 {.spacing = grid::margin, .margins = allAround(grid::margin)});
    showButtons();
}

QString OfferPage::effect() const
{
    return tr("Other programs can use the simulated ring. Nothing real is offered.");
}

void OfferPage::setPlace(const std::optional<OfferedPlace> &place)
{
    m_isOffered = place.has_value();
    if (place) {
        m_offered->setPlace(*place);
        m_files->setText(place->seats > 0 ? tr("Save f&iles for the seats…")
                                          : tr("Save a f&ile for clients…"));
    }
    m_parts->setCurrentIndex(m_isOffered ? 1 : 0);
    m_problem->withdraw();
    showButtons();
}

void OfferPage::setProblem(const Trouble &trouble)
{
    m_problem->showTrouble(Role::fault, trouble);
}

void OfferPage::tell(Role role, const QString &sentence)
{
    m_problem->showMessage(role, sentence);
}

void OfferPage::setWhyNot(const QString &sentence)
{
    if (std::exchange(m_whyNot, sentence) != sentence)
        showButtons();
}

void OfferPage::showButtons()
{
    m_offer->setVisible(!m_isOffered);
    m_end->setVisible(m_isOffered);
    m_files->setVisible(m_isOffered);
    m_offer->setEnabled(m_whyNot.isEmpty());
    m_offer->setToolTip(m_whyNot.isEmpty() ? tr("Other programs can use the ring from then on (Alt+O)")
                                           : m_whyNot);
    setFocusProxy(m_isOffered ? static_cast<QWidget *>(m_offered) : m_form);
}

// What is half typed is taken first, or nothing is done.
void OfferPage::offer()
{
    const QString wrong = takeFields(*m_form);
    if (wrong.isEmpty())
        Q_EMIT offerWanted(m_form->wish());
    else
        m_problem->showMessage(Role::attention, wrong);
}

} // namespace codewheel
