// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_board.h"

#include "widgets/cams/cam_program_strip.h"
#include "widgets/cams/cam_ruler.h"
#include "widgets/cams/cam_shift_spin.h"
#include "widgets/cams/cam_table.h"
#include "widgets/cams/cam_table_model.h"
#include "widgets/cams/cam_texts.h"
#include "widgets/cams/cam_word_picture.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/look/on_event.h"
#include "widgets/look/wrapped_label.h"

#include <QGridLayout>
#include <QPainter>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QToolButton>

namespace codewheel {
namespace {

constexpr int scrollSteps = 10'000; // of the scroll bar, for the whole range
constexpr int rulerOnPaper = 640;
constexpr int numbersOnPaper = 20;  // left of it
constexpr int roomForEncoder = 660; // below this width, ruler and strip alone tell what differs

// On paper no table stands beside the ruler.
PrintedPicture withNumbers(const PrintedPicture &picture, const CamRuler &ruler)
{
    PrintedPicture numbered{.drawing = QPicture(), .size = picture.size + QSize(numbersOnPaper, 0)};
    QPainter painter(&numbered.drawing);
    painter.setFont(numberFont(TextSize::small));
    for (std::size_t cam = 0; cam < ruler.sheet().abilities().cams; ++cam) {
        const QRect row = ruler.rowRect(cam);
        painter.drawText(QRect(0, row.top(), numbersOnPaper, row.height()), Qt::AlignCenter,
                         QString::number(cam));
    }
    painter.drawPicture(numbersOnPaper, 0, picture.drawing);
    return numbered;
}

} // namespace

CamBoard::CamBoard(CamSheet &sheet, QWidget *parent)
    : QWidget(parent)
    , m_sheet(sheet)
    , m_strip(new CamProgramStrip(sheet, this))
    , m_note(wrappedLabel(this))
    , m_table(new CamTable(sheet, this))
    , m_ruler(new CamRuler(sheet, this))
    , m_scroll(new QScrollBar(Qt::Horizontal, this))
    , m_shift(new CamShiftSpin(this))
    , m_word(new CamWordPicture(this))
{
    m_note->setFont(textFont(TextSize::small));
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    describe(m_scroll, tr("Scroll the ruler"), tr("Which part of the positions is visible"));

    auto *rows = new QGridLayout;
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(m_table, 0, 0, Qt::AlignTop);
    rows->addWidget(m_ruler, 0, 1, Qt::AlignTop);
    rows->addWidget(makeZoom(), 1, 0);
    rows->addWidget(m_scroll, 1, 1);
    rows->setColumnStretch(1, 1);
    m_shifting = makeWord();
    layOutColumn(this, {m_strip, m_note, rows, m_shifting, Stretch{1}},
                 {.spacing = grid::unit, .margins = QMargins()});
    setFocusProxy(m_table);
    connectParts();
    showScale();
    showShift();
    onEvent(this, {QEvent::Resize}, [this] {
        m_table->setColumnHidden(CamTableModel::encoderColumn, width() < roomForEncoder);
        m_table->updateGeometry();
    });
}

QWidget *CamBoard::makeZoom()
{
    auto *zoom = new QWidget(this);
    auto *row = new QHBoxLayout(zoom);
    row->setContentsMargins(0, 0, grid::unit, 0);
    row->setSpacing(0);
    row->addStretch();
    const auto add = [&](const QString &text, const QString &tip, void (CamRuler::*slot)()) {
        auto *button = describe(new QToolButton(zoom), tip, tip);
        button->setText(text);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
        connect(button, &QToolButton::clicked, m_ruler, slot);
        row->addWidget(button);
    };
    add(QStringLiteral("+"), tr("Zoom in (+)"), &CamRuler::zoomIn);
    add(QStringLiteral("\u2212"), tr("Zoom out (-)"), &CamRuler::zoomOut);
    add(tr("All"), tr("Show all positions (0)"), &CamRuler::zoomToAll);
    return zoom;
}

QWidget *CamBoard::makeWord()
{
    auto *word = new QWidget(this);
    auto *label = new QLabel(tr("&Shift"), word);
    label->setBuddy(m_shift);
    auto *grid = new QGridLayout(word);
    grid->setContentsMargins(0, grid::unit, 0, 0);
    grid->setHorizontalSpacing(grid::groupGap);
    grid->setVerticalSpacing(0);
    grid->addWidget(label, 0, 0, Qt::AlignBottom);
    grid->addWidget(m_shift, 1, 0, Qt::AlignTop);
    grid->addWidget(m_word, 0, 1, 2, 1);
    grid->setColumnStretch(1, 1);
    return word;
}

void CamBoard::connectParts()
{
    connect(m_strip, &CamProgramStrip::programChosen, this, &CamBoard::programChosen);
    connect(m_table, &CamTable::inputChecked, this, &CamBoard::inputChecked);
    connect(m_shift, &CamShiftSpin::inputChecked, this, &CamBoard::inputChecked);
    connect(m_shift, &QSpinBox::valueChanged, this,
            [this](int shift) { m_sheet.setShift(static_cast<unsigned>(shift)); });
    connect(m_ruler, &CamRuler::viewChanged, this, &CamBoard::showScale);
    connect(m_scroll, &QScrollBar::valueChanged, this, [this](int value) {
        m_ruler->scrollTo(static_cast<double>(value) / scrollSteps *
                          static_cast<double>(m_ruler->scale().total()));
    });
    connect(&m_sheet, &CamSheet::documentChanged, this, &CamBoard::showShift);
    connect(&m_sheet, &CamSheet::numberChanged, this, &CamBoard::showShift);
    connect(&m_sheet, &CamSheet::programChanged, this, &CamBoard::showShift);
    connect(&m_sheet, &CamSheet::largestChanged, this, &CamBoard::showShift);
}

void CamBoard::showScale()
{
    const RulerScale &scale = m_ruler->scale();
    const auto steps = [&](double positions) {
        return qRound(positions / static_cast<double>(scale.total()) * scrollSteps);
    };
    const QSignalBlocker quiet(m_scroll);
    m_scroll->setRange(0, scrollSteps - steps(scale.shown()));
    m_scroll->setPageStep(std::max(1, steps(scale.shown())));
    m_scroll->setSingleStep(std::max(1, steps(scale.shown()) / 10));
    m_scroll->setValue(steps(scale.first()));
    m_scroll->setEnabled(!scale.showsAll());
}

void CamBoard::showShift()
{
    const QSignalBlocker quiet(m_shift);
    m_shifting->setVisible(m_sheet.abilities().hasShift);
    m_shift->setValue(static_cast<int>(m_sheet.program().shift));
    m_word->setShift(m_sheet.program().shift, m_sheet.largest());
}

void CamBoard::setNote(const QString &sentence)
{
    m_note->setText(sentence);
}

bool CamBoard::finishEditing()
{
    if (!m_shift->hasAcceptableInput()) {
        m_shift->setFocus();
        return false;
    }
    m_shift->interpretText();
    return m_table->finishEditing();
}

void CamBoard::addTo(PrintedView &printed) const
{
    CamRuler ruler(m_sheet);
    const PrintedPicture rows = drawnOnPaper(ruler, {rulerOnPaper, ruler.sizeHint().height()});
    printed.pictures.push_back(withNumbers(rows, ruler));
    printed.values.emplace_back(tr("Program"), QString::number(m_sheet.number()));
    printed.values.emplace_back(
        tr("Positions"),
        m_sheet.knowsLargest() ? tr("0 to %1").arg(cam_texts::position(m_sheet.largest())) : tr("not known"));
    if (m_sheet.abilities().hasShift) {
        CamWordPicture word;
        word.setShift(m_sheet.program().shift, m_sheet.largest());
        printed.pictures.push_back(drawnOnPaper(word, {word.sizeHint().width(), word.sizeHint().height()}));
        printed.values.emplace_back(tr("Shift", "of the position"), QString::number(m_sheet.program().shift));
        printed.values.emplace_back(tr("What IN will hold"), word.valueText());
    }
    if (!m_note->text().isEmpty())
        printed.values.emplace_back(tr("Note"), m_note->text());
    printed.table = m_table;
}

} // namespace codewheel
