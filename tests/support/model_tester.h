// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemModelTester>

#include <gtest/gtest.h>

namespace codewheel::test {

// Keeps a model under QAbstractItemModelTester during its lifetime, so that the tester's findings fail the
// test. (In its default mode, GoogleTest does not see them.)
class ModelTester
{
public:
    explicit ModelTester(QAbstractItemModel &model)
        : m_tester(&model, QAbstractItemModelTester::FailureReportingMode::Warning)
    {
        if (s_alive++ == 0)
            s_previous = qInstallMessageHandler(handle);
    }
    ~ModelTester()
    {
        if (--s_alive == 0)
            qInstallMessageHandler(s_previous);
    }
    ModelTester(const ModelTester &) = delete;
    ModelTester &operator=(const ModelTester &) = delete;

private:
    static void handle(QtMsgType type, const QMessageLogContext &context, const QString &text)
    {
        if (qstrcmp(context.category, "qt.modeltest") == 0 && type != QtDebugMsg && type != QtInfoMsg)
            ADD_FAILURE() << text.toStdString();
        else if (s_previous != nullptr)
            s_previous(type, context, text);
    }

    static inline int s_alive = 0;
    static inline QtMessageHandler s_previous = nullptr;
    QAbstractItemModelTester m_tester;
};

} // namespace codewheel::test
