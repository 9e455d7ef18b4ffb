// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/question.h"

#include "widgets/help/help_topic.h"
#include "widgets/look/label_text.h"

#include <QAbstractButton>
#include <QApplication>
#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>
#include <QTest>
#include <QTimer>
#include <QWidget>

#include <gtest/gtest.h>

namespace codewheel::test {
namespace {

void clickButton(QWidget &dialog, const QString &beginning)
{
    for (QAbstractButton *button : dialog.findChildren<QAbstractButton *>()) {
        if (button->isVisible() && button->isEnabled() && plainLabel(button->text()).startsWith(beginning)) {
            QTest::mouseClick(button, Qt::LeftButton);
            return;
        }
    }
    ADD_FAILURE() << "the question has no button that can be pressed, " << beginning.toStdString();
    dialog.close();
}

} // namespace

struct Question::State
{
    QTimer timer;
    bool asked = false;
    QString text;
};

Question Question::answeredBy(const QString &button)
{
    return Question([button](QWidget &dialog) { clickButton(dialog, button); });
}

Question::Question(std::function<void(QWidget &)> answer)
    : m_state(std::make_shared<State>())
{
    State *state = m_state.get();
    QObject::connect(&state->timer, &QTimer::timeout, &state->timer, [state, answer = std::move(answer)] {
        QWidget *dialog = QApplication::activeModalWidget();
        if (dialog == nullptr || !dialog->isVisible())
            return;
        state->timer.stop();
        const bool isOfFiles = qobject_cast<QFileDialog *>(dialog) != nullptr ||
                               qobject_cast<QFileDialog *>(dialog->parentWidget()) != nullptr;
        EXPECT_FALSE(helpTopicOf(dialog).isEmpty() && !isOfFiles)
            << "F1 knows nothing of " << dialog->windowTitle().toStdString();
        state->asked = true;
        if (const auto *box = qobject_cast<QMessageBox *>(dialog))
            state->text = box->text() + u'\n' + box->informativeText();
        else
            for (const auto *label : dialog->findChildren<QLabel *>())
                state->text += label->text() + u'\n';
        answer(*dialog);
    });
    state->timer.start(1);
}

Question::~Question()
{
    if (m_state && !m_state->asked)
        ADD_FAILURE() << "no question was asked";
}

Question::Question(Question &&) noexcept = default;

bool Question::wasAsked() const
{
    return m_state->asked;
}

QString Question::text() const
{
    return m_state->text;
}

} // namespace codewheel::test
