// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/recording/encoder_choice.h"

#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"

#include <QHeaderView>
#include <QRadioButton>
#include <QTreeWidget>

namespace codewheel {
namespace {

constexpr int rowsInSight = 5;

} // namespace

EncoderChoice::EncoderChoice(const std::vector<RecordableEncoder> &encoders, QWidget *parent)
    : QWidget(parent)
    , m_all(describe(new QRadioButton(tr("&All encoders"), this), "recordAll",
                     tr("Of all buses, and those that are connected later")))
    , m_some(describe(new QRadioButton(tr("&Only these:"), this), "recordSome",
                      tr("Only the encoders that are ticked below")))
    , m_list(describe(new QTreeWidget(this), "recordedEncoders", tr("Encoders"),
                      tr("Encoders that are ticked are recorded (Space)")))
{
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setHeaderHidden(true);
    m_list->setColumnCount(2);
    for (const RecordableEncoder &encoder : encoders) {
        auto *row = new QTreeWidgetItem(m_list, {encoder.name, encoder.what});
        row->setCheckState(0, Qt::Unchecked);
        m_places.push_back(encoder.place);
    }
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_list->setFixedHeight(rowsInSight * m_list->sizeHintForRow(0) + 2 * m_list->frameWidth() + grid::unit);
    if (const QModelIndex first = m_list->model()->index(0, 0); first.isValid())
        m_list->setCurrentIndex(first);
    m_some->setEnabled(!encoders.empty());
    m_all->setChecked(true);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    m_list->hide();
    layOutColumn(this, {m_all, m_some, m_list}, {.spacing = grid::unit, .margins = QMargins()});
    connect(m_some, &QRadioButton::toggled, this, [this](bool some) {
        m_list->setVisible(some);
        Q_EMIT changed();
    });
    connect(m_list, &QTreeWidget::itemChanged, this, &EncoderChoice::changed);
}

std::set<Place> EncoderChoice::ticked() const
{
    std::set<Place> places;
    for (std::size_t i = 0; i < m_places.size(); ++i)
        if (m_list->topLevelItem(static_cast<int>(i))->checkState(0) == Qt::Checked)
            places.insert(m_places[i]);
    return places;
}

std::set<Place> EncoderChoice::places() const
{
    return m_all->isChecked() ? std::set<Place>() : ticked();
}

bool EncoderChoice::isNone() const
{
    return m_some->isChecked() && ticked().empty();
}

// Those that are not there any more are left out.
void EncoderChoice::setPlaces(const std::set<Place> &places)
{
    for (std::size_t i = 0; i < m_places.size(); ++i)
        m_list->topLevelItem(static_cast<int>(i))
            ->setCheckState(0, places.contains(m_places[i]) ? Qt::Checked : Qt::Unchecked);
    (ticked().empty() ? m_all : m_some)->setChecked(true);
}

} // namespace codewheel
