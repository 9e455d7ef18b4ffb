// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

#include <functional>
#include <memory>

namespace codewheel::test {

// Answers the next modal question as a person would: waits until it is on the screen, then acts on it. Fails
// the test if none has appeared during its lifetime.
class Question
{
public:
    // Clicks the button whose text, without '&', starts like this.
    static Question answeredBy(const QString &button);
    explicit Question(std::function<void(QWidget &dialog)> answer);
    ~Question();
    Question(Question &&) noexcept;

    bool wasAsked() const;
    QString text() const; // the whole text of a message box

private:
    struct State;
    std::shared_ptr<State> m_state;
};

} // namespace codewheel::test
