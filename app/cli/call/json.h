// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "cli/call/complaint.h"
#include "vocabulary/known.h"
#include "vocabulary/meaning.h"
#include "vocabulary/reading.h"
#include "vocabulary/rod_scale.h"

#include <QJsonArray>
#include <QJsonObject>

namespace codewheel {

// The language-neutral schema of --json, documented in docs/command-line.md: numbers are numbers, words are
// strings of eight hexadecimal digits, everything that has a name is given by its key.
QJsonValue wordJson(Word word);
QJsonValue numberJson(std::optional<std::int64_t> number); // null where there is none
// For what cannot be 0, where 0 means not known: then null.
QJsonValue knownJson(std::int64_t number);
// null if the position or the scale of the rod is not known
QJsonValue millimetresJson(std::optional<std::int64_t> position, const std::optional<RodScale> &scale);
QJsonArray meaningsJson(const Explanation &explanation);
QJsonObject errorJson(const Complaint &complaint);
QJsonArray argumentsJson(const std::vector<RefusalArgument> &arguments);
// {"parameter", "value", "choice", "unit"}; choice only if the value has a name.
QJsonObject valueJson(const ParameterDescription &parameter, const Value &value);

// "known" and "evidence", null if nothing is known.
void addKnown(QJsonObject &json, const std::optional<Known> &known);
// How it is known, and how it is kept if there is something to say.
void addEvidence(QJsonObject &json, const std::optional<Known> &known);
void addKept(QJsonObject &json, const std::optional<Known> &known);
QJsonValue textJson(const QString &text); // null where it is empty
// Copies everything in `more` into `into`.
void merge(QJsonObject &into, const QJsonObject &more);

QString unitKey(Unit unit);
QString evidenceKey(Evidence evidence);
QString stateKey(EncoderState state);
QJsonValue modeJson(std::optional<Mode> mode); // null where it is not known

} // namespace codewheel
