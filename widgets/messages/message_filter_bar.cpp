// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/message_filter_bar.h"

#include "journal/message_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/look/may_elide.h"
#include "widgets/look/roles.h"

#include <QAction>
#include <QComboBox>
#include <QDateTimeEdit>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QStyleOptionComboBox>
#include <QStylePainter>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int firstPlace = 2; // after "all places" and "no device"
constexpr int daysOfWeek = 7;
constexpr int shortChoice = 6; // characters
constexpr int shortestSearch = 26 * grid::unit;
constexpr int shortestChoice = 16 * grid::unit; // in a small window

// Elides its text in a narrow panel.
class ElidedChoice : public QComboBox
{
public:
    using QComboBox::QComboBox;

protected:
    void paintEvent(QPaintEvent *) override
    {
        QStylePainter painter(this);
        QStyleOptionComboBox option;
        initStyleOption(&option);
        painter.drawComplexControl(QStyle::CC_ComboBox, option);
        const int room =
            style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this).width();
        option.currentText = fontMetrics().elidedText(currentText(), Qt::ElideRight, room - grid::unit);
        painter.drawControl(QStyle::CE_ComboBoxLabel, option);
    }
};

} // namespace

MessageFilterBar::MessageFilterBar(QWidget *parent)
    : QWidget(parent)
    , m_start(QDateTime::currentDateTime())
    , m_row(new QHBoxLayout)
    , m_span(new QWidget(this))
    , m_search(describe(new QLineEdit(this), tr("Search in messages"),
                        tr("Show only messages with this text (Ctrl+F)")))
    , m_severity(describe(new ElidedChoice(this), tr("Severity of messages"),
                          tr("Show only messages of this severity or worse")))
    , m_place(describe(new ElidedChoice(this), tr("Place of messages"),
                       tr("Show only messages of this device, of this bus and its devices, or of no device")))
    , m_period(describe(new ElidedChoice(this), tr("Time of messages"),
                        tr("Show only messages of this time; the start is that of the program")))
    , m_from(new QDateTimeEdit(m_span))
    , m_until(new QDateTimeEdit(m_span))
    , m_find(new QAction(tr("Search"), this))
{
    makeSearch();
    makeChoices();
    makeSpan();
    m_row->setSpacing(grid::unit);
    m_row->addWidget(m_search, 1);
    for (QWidget *choice : {m_severity, m_place, m_period})
        m_row->addWidget(choice, 1);
    m_row->addSpacing(grid::unit);
    auto *column = layOut<QVBoxLayout>(this, grid::unit);
    column->addLayout(m_row);
    column->addWidget(m_span);
}

void MessageFilterBar::makeSearch()
{
    m_search->setPlaceholderText(tr("Search"));
    m_search->setClearButtonEnabled(true);
    m_search->setMinimumWidth(shortestSearch);
    m_search->addAction(lineIcon(Icon::search, Role::inactive), QLineEdit::LeadingPosition);
    m_find->setShortcut(QKeySequence::Find);
    m_find->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(m_find, &QAction::triggered, this, [this] {
        m_search->setFocus(Qt::ShortcutFocusReason);
        m_search->selectAll();
    });
    connect(m_search, &QLineEdit::textChanged, this, &MessageFilterBar::changed);
}

void MessageFilterBar::makeChoices()
{
    m_severity->addItem(tr("All", "messages"), QVariant::fromValue(Severity::information));
    m_severity->addItem(tr("Attention and faults"), QVariant::fromValue(Severity::attention));
    m_severity->addItem(tr("Faults only"), QVariant::fromValue(Severity::fault));
    m_place->addItem(tr("Everywhere"), QVariant::fromValue(MessageFilter::Where{}));
    m_place->addItem(tr("No device"), QVariant::fromValue(MessageFilter::Where{.all = false}));
    m_period->addItem(tr("Any time"), QVariant::fromValue(Period::all));
    m_period->addItem(tr("Since the start"), QVariant::fromValue(Period::sinceStart));
    m_period->addItem(tr("Last hour"), QVariant::fromValue(Period::lastHour));
    m_period->addItem(tr("Today"), QVariant::fromValue(Period::today));
    m_period->addItem(tr("Last 7 days"), QVariant::fromValue(Period::lastWeek));
    m_period->addItem(tr("From … to …"), QVariant::fromValue(Period::between));
    for (QComboBox *choice : {m_severity, m_place, m_period}) {
        choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        choice->setMinimumContentsLength(shortChoice);
        choice->setMinimumWidth(shortestChoice);
        allowEliding(*choice);
        choice->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    }
    for (QComboBox *choice : {m_severity, m_place})
        connect(choice, &QComboBox::currentIndexChanged, this, &MessageFilterBar::changed);
    connect(m_period, &QComboBox::currentIndexChanged, this, &MessageFilterBar::choosePeriod);
}

void MessageFilterBar::makeSpan()
{
    auto *row = layOut<QHBoxLayout>(m_span, grid::unit);
    row->addStretch(1);
    const auto add = [&](const QString &text, QDateTimeEdit *edit, const QString &name) {
        auto *label = new QLabel(text, m_span);
        label->setBuddy(edit);
        edit->setCalendarPopup(true);
        describe(edit, name, name);
        row->addWidget(label);
        row->addWidget(edit);
        connect(edit, &QDateTimeEdit::dateTimeChanged, this, &MessageFilterBar::changed);
    };
    add(tr("&From"), m_from, tr("Show messages from this date and time on"));
    add(tr("&to"), m_until, tr("Show messages before this date and time"));
    m_span->hide();
}

void MessageFilterBar::choosePeriod()
{
    const auto now = QDateTime::currentDateTime();
    const auto period = m_period->currentData().value<Period>();
    m_since.reset();
    switch (period) {
    case Period::sinceStart:
        m_since = m_start;
        break;
    case Period::lastHour:
        m_since = now.addSecs(-3'600);
        break;
    case Period::today:
        m_since = now.date().startOfDay();
        break;
    case Period::lastWeek:
        m_since = now.addDays(-daysOfWeek);
        break;
    case Period::between:
        m_from->setDateTime(now.date().startOfDay());
        m_until->setDateTime(now.date().addDays(1).startOfDay());
        break;
    case Period::all:
        break;
    }
    m_span->setVisible(period == Period::between);
    Q_EMIT changed();
}

MessageFilter MessageFilterBar::filter() const
{
    MessageFilter filter{.least = m_severity->currentData().value<Severity>(),
                         .place = m_place->currentData().value<MessageFilter::Where>(),
                         .text = m_search->text().trimmed()};
    if (m_since)
        filter.from = m_since->toMSecsSinceEpoch();
    if (m_period->currentData().value<Period>() == Period::between) {
        filter.from = m_from->dateTime().toMSecsSinceEpoch();
        filter.until = m_until->dateTime().toMSecsSinceEpoch();
    }
    return filter;
}

void MessageFilterBar::setPlaces(const std::vector<Place> &places)
{
    for (const Place place : places) {
        const auto before = [&](int index) {
            return *m_place->itemData(index).value<MessageFilter::Where>().at < place;
        };
        int index = firstPlace;
        while (index < m_place->count() && before(index))
            ++index;
        if (m_place->itemText(index) != placeName(place))
            m_place->insertItem(index, placeName(place),
                                QVariant::fromValue(MessageFilter::Where{.all = false, .at = place}));
    }
}

void MessageFilterBar::showAll()
{
    {
        const QSignalBlocker once(this);
        m_search->clear();
        for (QComboBox *choice : {m_severity, m_place, m_period})
            choice->setCurrentIndex(0);
    }
    Q_EMIT changed();
}

} // namespace codewheel
