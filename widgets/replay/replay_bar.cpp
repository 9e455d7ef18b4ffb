// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/replay/replay_bar.h"

#include "vocabulary/freshness_text.h"
#include "vocabulary/refusal_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/role_label.h"
#include "widgets/look/tool.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/replay/replay_slider.h"

#include <QAction>
#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <QToolBar>

#include <array>

namespace codewheel {
namespace {

using Direction = Playback::Direction;

constexpr std::array speeds{0.1, 1.0, 10.0, 100.0, 1'000.0};
constexpr int usualSpeed = 1;

QString speedText(double speed)
{
    return QStringLiteral("%1×").arg(QLocale().toString(speed));
}

} // namespace

ReplayBar::ReplayBar(Playback &playback, QWidget *parent)
    : QWidget(parent)
    , m_playback(playback)
    , m_what(new RoleLabel(this))
    , m_moment(named(new QLabel(this), "replayTime"))
    , m_tools(new QToolBar(this))
    , m_speed(new QComboBox(this))
    , m_slider(new ReplaySlider(playback, this))
    , m_from(named(new QLabel(this), "replayFrom"))
    , m_to(named(new QLabel(this), "replayTo"))
    , m_told(wrappedLabel(this, "replayMessage"))
    , m_message(new InlineMessage(this))
{
    setObjectName(QStringLiteral("replayBar"));
    setAccessibleName(tr("Recording"));
    m_what->setState(Role::inactive, tr("Recording: %1").arg(QFileInfo(playback.file()).fileName()));
    m_what->setToolTip(playback.file());
    makeTools();
    makeSpeeds();
    arrange();
    connect(&playback, &Playback::stateChanged, this, &ReplayBar::showState);
    connect(&playback, &Playback::positionChanged, this, &ReplayBar::showMoment);
    showState();
}

QAction *ReplayBar::addAction(Icon icon, const QString &text, const QKeySequence &key, const QString &tip)
{
    QAction *action = addTool(*this, *m_tools, {icon, text, key, tip});
    action->setShortcutContext(Qt::WindowShortcut);
    return action;
}

void ReplayBar::makeTools()
{
    setUpToolBar(*m_tools);
    const auto goTo = [this](QAction *action, Instant TimeSpan::*end) {
        connect(action, &QAction::triggered, this, [this, end] {
            m_playback.pause();
            m_playback.jumpTo(m_playback.span().*end);
        });
    };
    goTo(addAction(Icon::toBegin, tr("Beginning"), Qt::CTRL | Qt::ALT | Qt::Key_Home,
                   tr("To the beginning of the recording")),
         &TimeSpan::from);
    connect(addAction(Icon::stepBack, tr("Step back"), Qt::CTRL | Qt::ALT | Qt::Key_Comma,
                      tr("To the previous sample of the chosen encoder")),
            &QAction::triggered, this, [this] { step(Direction::backward); });
    m_backward = addAction(Icon::playBack, tr("Backward"), Qt::CTRL | Qt::ALT | Qt::Key_B,
                           tr("Plays the recording backward"));
    m_pause = addAction(Icon::pause, tr("Pause"), Qt::CTRL | Qt::ALT | Qt::Key_P, tr("Stands still"));
    m_forward =
        addAction(Icon::start, tr("Play"), Qt::CTRL | Qt::ALT | Qt::Key_F, tr("Plays the recording forward"));
    connect(addAction(Icon::step, tr("Step"), Qt::CTRL | Qt::ALT | Qt::Key_Period,
                      tr("To the next sample of the chosen encoder")),
            &QAction::triggered, this, [this] { step(Direction::forward); });
    goTo(addAction(Icon::toEnd, tr("End"), Qt::CTRL | Qt::ALT | Qt::Key_End,
                   tr("To the end of the recording")),
         &TimeSpan::to);
    connect(addAction(Icon::cancel, tr("Close"), {}, tr("Closes the recording")), &QAction::triggered, this,
            &ReplayBar::closeRequested);
    for (QAction *action : {m_backward, m_forward})
        action->setCheckable(true);
    connect(m_backward, &QAction::triggered, this, [this] { play(Direction::backward); });
    connect(m_forward, &QAction::triggered, this, [this] { play(Direction::forward); });
    connect(m_pause, &QAction::triggered, &m_playback, &Playback::pause);
}

void ReplayBar::makeSpeeds()
{
    describe(m_speed, "replaySpeed", tr("Speed"),
             tr("How fast the recording is played (Ctrl+Alt++: faster, Ctrl+Alt+-: slower)"));
    for (const double speed : speeds)
        m_speed->addItem(speedText(speed), speed);
    m_speed->setCurrentIndex(usualSpeed);
    connect(m_speed, &QComboBox::currentIndexChanged, this,
            [this](int index) { m_playback.setFactor(m_speed->itemData(index).toDouble()); });
    const auto addKeys = [this](const QString &text, const QList<QKeySequence> &keys, int by) {
        auto *action = new QAction(text, this);
        action->setShortcuts(keys);
        connect(action, &QAction::triggered, this, [this, by] { changeSpeed(by); });
        QWidget::addAction(action);
    };
    addKeys(tr("Faster"), {Qt::CTRL | Qt::ALT | Qt::Key_Plus, Qt::CTRL | Qt::ALT | Qt::Key_Equal}, 1);
    addKeys(tr("Slower"), {Qt::CTRL | Qt::ALT | Qt::Key_Minus}, -1);
}

void ReplayBar::arrange()
{
    m_moment->setFont(numberFont());
    for (QLabel *end : {m_from, m_to})
        end->setFont(numberFont(TextSize::small));
    describe(m_told, tr("Message of then"), tr("What the program said when this was recorded"));
    m_told->setFont(textFont(TextSize::small));
    m_told->hide();
    m_moment->setAccessibleName(tr("Time shown"));
    m_moment->setToolTip(tr("When what is shown was recorded"));
    const LayoutRoom close{grid::unit, QMargins()};
    layOutColumn(
        this,
        {layOutRow({m_what, Stretch{1}, m_moment, m_speed}, close), m_tools,
         layOutRow({m_from, {m_slider, 1}, m_to}, close), m_told, m_message},
        {.spacing = grid::unit, .margins = QMargins(grid::margin, grid::unit, grid::margin, grid::unit)});
}

void ReplayBar::play(Direction direction)
{
    const bool isPlaying = m_playback.isPlaying() && m_playback.direction() == direction;
    if (isPlaying)
        m_playback.pause();
    else
        m_playback.play(direction);
    showState(); // the buttons follow the recording, not the click
}

void ReplayBar::step(Direction direction)
{
    m_playback.step(direction, m_encoder);
}

void ReplayBar::changeSpeed(int by)
{
    m_speed->setCurrentIndex(std::clamp(m_speed->currentIndex() + by, 0, m_speed->count() - 1));
}

void ReplayBar::showState()
{
    const bool isForward = m_playback.direction() == Direction::forward;
    m_forward->setChecked(m_playback.isPlaying() && isForward);
    m_backward->setChecked(m_playback.isPlaying() && !isForward);
    m_pause->setEnabled(m_playback.isPlaying());
    m_speed->setCurrentIndex(m_speed->findData(m_playback.factor()));
    m_from->setText(recordedText(m_playback.dateTime(m_playback.span().from)));
    m_to->setText(recordedText(m_playback.dateTime(m_playback.span().to)));
    showMoment();
}

void ReplayBar::showMoment()
{
    const QDateTime moment = m_playback.dateTime(m_playback.position()).toLocalTime();
    m_moment->setText(QStringLiteral("%1 %2").arg(QLocale().toString(moment.date(), QLocale::ShortFormat),
                                                  moment.time().toString(QStringLiteral("HH:mm:ss.zzz"))));
    m_slider->showMoment();
    if (m_playback.jumps() != m_toldBefore)
        m_told->hide();
    showProblem();
}

void ReplayBar::tell(const QString &message)
{
    m_toldBefore = m_playback.jumps();
    m_told->setText(message);
    m_told->show();
}

void ReplayBar::showProblem()
{
    const auto problem = m_playback.problem();
    if (std::exchange(m_problem, problem) != problem && problem)
        m_message->showMessage(Role::fault, refusalText(*problem));
}

} // namespace codewheel
