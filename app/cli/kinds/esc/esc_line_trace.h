// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/line/row_text.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QObject>

#include <vector>

namespace codewheel {

class EscLineSession;

// Collects what passes on a line as long as it lives, except the polling of positions.
class EscLineTrace : public QObject
{
public:
    explicit EscLineTrace(EscLineSession &line);

    const std::vector<PassedRow> &rows() const { return m_rows; }

private:
    std::optional<esc::Request> m_request;
    std::vector<PassedRow> m_rows;
};

// One row each: time, direction, bytes as text, meaning.
QString lineTraceText(const std::vector<PassedRow> &rows, const esc::ExplainOptions &options);
QJsonObject rowJson(const PassedRow &row, const esc::ExplainOptions &options);
QJsonArray lineTraceJson(const std::vector<PassedRow> &rows, const esc::ExplainOptions &options);

// The keys of the bits that are set in an answer to O, A or E.
QJsonArray bitsJson(esc::Command command, std::uint16_t word);
// {"address", "letters", "data"}; data null for a read.
QJsonObject requestJson(const esc::Request &request);
// {"answer", "value" or "version", "bits"}; bits only if the answer has any.
QJsonObject answerJson(const esc::Request &request, const esc::Answer &answer,
                       const esc::ExplainOptions &options);

} // namespace codewheel
