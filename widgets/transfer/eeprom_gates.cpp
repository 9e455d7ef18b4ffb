// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/transfer/eeprom_gates.h"

#include "bus/buses.h"
#include "journal/eeprom_cost.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QVBoxLayout>

#include <algorithm>
#include <numeric>
#include <utility>

namespace codewheel {
namespace {

constexpr int mostTold = 4; // encoders; the table above needs the room

// Of the plan's jobs: to the cost told above that of leaving a cam program that was changed is added.
int writesOf(const EncoderSession &encoder, const EncoderPlan &plan)
{
    const int ofJobs = std::accumulate(plan.jobs.begin(), plan.jobs.end(), 0, [&](int sum, const Job &job) {
        return sum + mostEepromWrites(encoder, job);
    });
    return std::max(plan.eepromWrites, ofJobs);
}

QString placesOf(const std::vector<Place> &numbers)
{
    QStringList places;
    for (const Place number : numbers)
        places << number.shown();
    return places.join(u' ');
}

} // namespace

EepromGates::EepromGates(const Buses &buses, QWidget *parent)
    : QWidget(parent)
    , m_buses(buses)
    , m_text(new QLabel(this))
    , m_nevertheless(describe(new QCheckBox(tr("Write &nevertheless"), this), "writeNevertheless",
                              tr("The EEPROM was written as often as the manual speaks of")))
    , m_places(describe(new QLineEdit(this), "typedPlace", tr("Places of the encoders"),
                        tr("The places of these encoders, so that nothing is written beyond the limit by "
                           "accident")))
{
    m_text->setWordWrap(true);
    m_text->setObjectName(QStringLiteral("eepromConcern"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(grid::unit);
    layout->addWidget(m_text);
    layout->addWidget(m_nevertheless);
    layout->addWidget(m_places);
    connect(m_nevertheless, &QCheckBox::toggled, this, &EepromGates::changed);
    connect(m_places, &QLineEdit::textChanged, this, &EepromGates::changed);
    hide();
}

void EepromGates::setPlan(const TransferPlan &plan)
{
    QStringList texts;
    std::vector<Place> asked;
    std::vector<Place> typed;
    for (const EncoderPlan &one : plan) {
        const EncoderSession *encoder = m_buses.encoder(one.place);
        const int planned = encoder ? writesOf(*encoder, one) : 0;
        const EepromConcern concern = encoder ? eepromConcern(*encoder, planned) : EepromConcern::none;
        if (concern == EepromConcern::none)
            continue;
        texts << QStringLiteral("%1: %2").arg(one.place.shown(), eepromConcernText(*encoder, planned));
        if (concern == EepromConcern::question)
            asked.push_back(one.place);
        if (concern == EepromConcern::typed)
            typed.push_back(one.place);
    }
    if (std::exchange(m_asked, asked) != asked)
        m_nevertheless->setChecked(false);
    if (std::exchange(m_typed, typed) != typed)
        m_places->clear();
    if (texts.size() > mostTold)
        texts = texts.first(mostTold) << tr("Other encoders as well: %1.").arg(texts.size() - mostTold);
    m_text->setText(texts.join(u'\n'));
    const QString ask = tr("Type %1 to write nevertheless").arg(placesOf(m_typed));
    m_places->setPlaceholderText(ask);
    m_places->setAccessibleName(ask);
    m_nevertheless->setVisible(!m_asked.empty());
    m_places->setVisible(!m_typed.empty());
    setVisible(!texts.isEmpty());
}

bool EepromGates::isOpen() const
{
    static const QRegularExpression between(QStringLiteral("[\\s,;]+"));
    const QStringList places = m_places->text().split(between, Qt::SkipEmptyParts);
    const bool allTyped =
        std::ranges::all_of(m_typed, [&](Place number) { return places.contains(number.shown()); });
    return allTyped && (m_asked.empty() || m_nevertheless->isChecked());
}

} // namespace codewheel
