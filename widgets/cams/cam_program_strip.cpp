// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_program_strip.h"

#include "widgets/cams/cam_circle.h"
#include "widgets/cams/cam_sheet.h"
#include "widgets/look/appearance.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/on_event.h"
#include "widgets/look/roles.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int lineHeight = 3; // per cam in miniature, with the gap below it
constexpr int stateMarkSize = 12;
constexpr int paleState = 110;

} // namespace

CamProgramButton::CamProgramButton(CamSheet &sheet, unsigned number, QWidget *parent)
    : QAbstractButton(parent)
    , m_sheet(sheet)
    , m_number(number)
{
    setCheckable(true);
    setAttribute(Qt::WA_Hover);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setText(QString::number(number));
    setAccessibleName(tr("Cam program %1").arg(number));
    describe();
    onEvent(this, {QEvent::StyleChange}, [this] { updateGeometry(); });
}

void CamProgramButton::describe()
{
    const CamProgram &program = m_sheet.document().program(m_number);
    const auto active = std::ranges::count(program.cam, true, &Cam::active);
    const auto differs = m_sheet.differs(m_number);
    const bool isOld = m_sheet.isOld();
    QStringList lines{tr("%1 of %2 cams are active.").arg(active).arg(m_sheet.abilities().cams)};
    lines << (!differs ? tr("What the encoder has is not known.")
              : *differs
                  ? isOld ? tr("The encoder had another program.") : tr("The encoder has another program.")
              : isOld ? tr("The encoder had the same.")
                      : tr("The encoder has the same."))
          << m_sheet.howKnown(m_number);
    lines.removeAll(QString());
    const QString text = lines.join(u'\n');
    setToolTip(tr("Cam program %1").arg(m_number) + QLatin1Char('\n') + text);
    setAccessibleDescription(text);
    update();
}

QSize CamProgramButton::sizeHint() const
{
    const int cams = static_cast<int>(CamProgram::cams) * lineHeight;
    return {24 * grid::unit, std::max(qRound(34 * controlFactor(*this)), cams + 2 * grid::unit)};
}

QSize CamProgramButton::minimumSizeHint() const
{
    return {9 * grid::unit, sizeHint().height()};
}

void CamProgramButton::drawCams(QPainter &painter, const QRectF &room) const
{
    const CamProgram &program = m_sheet.document().program(m_number);
    const double perPosition = room.width() / static_cast<double>(m_sheet.largest() + 1);
    double top = room.center().y() - static_cast<double>(CamProgram::cams) * lineHeight / 2;
    for (const Cam &cam : program.cam) {
        QColor color = roleColor(cam.active ? Role::setBit : Role::inactive, palette());
        if (!cam.active)
            color.setAlpha(paleState);
        if (!cam_circle::isEmpty(cam))
            for (const auto &stretch : cam_circle::stretches(cam, m_sheet.largest())) {
                const double left = room.left() + static_cast<double>(stretch.first) * perPosition;
                const double width = static_cast<double>(stretch.last + 1 - stretch.first) * perPosition;
                painter.fillRect(QRectF(left, top, std::max(width, 1.5), lineHeight - 1).intersected(room),
                                 color);
            }
        top += lineHeight;
    }
}

void CamProgramButton::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const QRect box = rect().adjusted(0, 0, -1, -1);
    painter.setPen(Qt::NoPen);
    painter.fillRect(box, palette().color(isChecked() ? QPalette::Base : QPalette::Button));
    const QColor text = palette().color(QPalette::ButtonText);
    QFont number = font();
    number.setBold(isChecked());
    painter.setFont(number);
    painter.setPen(text);
    const int digit = painter.fontMetrics().horizontalAdvance(QStringLiteral("8"));
    const QRect label(box.left() + grid::unit + 1, box.top(), digit + 2, box.height());
    painter.drawText(label, Qt::AlignCenter, this->text());
    const bool isMarked = m_sheet.differs(m_number).value_or(false);
    const int right = isMarked ? stateMarkSize + grid::unit : grid::unit;
    drawCams(painter, QRectF(box).adjusted(label.right() + grid::unit, 2, -right, -2));
    if (isMarked)
        lineIcon(Icon::attention, m_sheet.isOld() ? Role::inactive : Role::attention)
            .paint(&painter,
                   QRect(box.right() - stateMarkSize - 1, box.top() + 2, stateMarkSize, stateMarkSize));

    painter.setBrush(Qt::NoBrush);
    if (isChecked())
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    else
        painter.setPen(underMouse() ? text : roleColor(Role::inactive, palette()));
    painter.drawRect(isChecked() ? box.adjusted(1, 1, 0, 0) : box);
    if (hasFocus()) {
        painter.setPen(QPen(text, 1, Qt::DotLine));
        painter.drawRect(box.adjusted(3, 3, -3, -3));
    }
}

CamProgramStrip::CamProgramStrip(CamSheet &sheet, QWidget *parent)
    : QWidget(parent)
    , m_sheet(sheet)
{
    setAccessibleName(tr("Cam programs"));
    auto *group = new QButtonGroup(this);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    for (unsigned number = 1; number <= CamProgram::programs; ++number) {
        auto *button = new CamProgramButton(sheet, number, this);
        group->addButton(button);
        row->addWidget(button);
        m_buttons.at(number - 1) = button;
        connect(button, &QAbstractButton::clicked, this, [this, number] { Q_EMIT programChosen(number); });
    }
    connect(&sheet, &CamSheet::numberChanged, this, &CamProgramStrip::refresh);
    connect(&sheet, &CamSheet::documentChanged, this, &CamProgramStrip::refresh);
    connect(&sheet, &CamSheet::largestChanged, this, &CamProgramStrip::refresh);
    connect(&sheet, &CamSheet::programChanged, this,
            [this](unsigned number) { m_buttons.at(number - 1)->describe(); });
    refresh();
}

void CamProgramStrip::refresh()
{
    m_buttons.at(m_sheet.number() - 1)->setChecked(true);
    for (unsigned number = 1; number <= CamProgram::programs; ++number) {
        m_buttons.at(number - 1)->setVisible(number <= m_sheet.abilities().programs);
        m_buttons.at(number - 1)->describe();
    }
    setVisible(m_sheet.abilities().programs > 1);
}

QList<KeyHelp> CamProgramStrip::keys()
{
    return {{QStringLiteral("1 \u2026 8"), tr("Opens the program with this number")}};
}

void CamProgramStrip::keyPressEvent(QKeyEvent *event)
{
    if (event->key() < Qt::Key_0 || event->key() > Qt::Key_9) {
        QWidget::keyPressEvent(event);
        return;
    }
    const auto number = static_cast<unsigned>(event->key() - Qt::Key_0);
    if (number >= 1 && number <= m_sheet.abilities().programs)
        m_buttons.at(number - 1)->setFocus();
    Q_EMIT programChosen(number);
}

} // namespace codewheel
