// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transfer/replacement.h"
#include "transfer/transfer_account.h"

#include <QJsonArray>
#include <QJsonObject>

namespace codewheel {

struct Call;

// What `transfer` and `clone` are about to do, and what became of it: encoder by encoder, for people and for
// programs (docs/command-line.md).
QString planText(const Call &call, const TransferPlan &plan);
QJsonArray planJson(const Call &call, const TransferPlan &plan);
QString accountText(const Call &call, const TransferAccount &account);
QJsonArray accountJson(const Call &call, const TransferAccount &account);
// null, or {"key", "text"}
QJsonValue refusalJson(const std::optional<Refusal> &refusal);
// For `replace`.
QJsonObject differencesJson(const ReplacementDifferences &differences);

} // namespace codewheel
