// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

#include <functional>
#include <memory>

namespace codewheel::test {

// Answers the next modal question as a person would: waits until it is on the screen, then does something
// with it. Fails the test if none came while this object lived.
class Question
{
public:
    // Clicks the button whose text, without '&', begins so.
    static Question answeredBy(const QString &button);
    explicit Question(std::function<void(QWidget &dialog)> answer);
    ~Question();
    Question(Question &&) noexcept;

    bool wasAsked() const;
    QString text() const; // of a message box, all of it

private:
    struct State;
    std::shared_ptr<State> m_state;
};

} // namespace codewheel::test
