// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/participant.h"
#include "catalog/device_description.h"
#include "cli/complaint.h"
#include "encoder/known.h"
#include "encoder/reading.h"
#include "encoder/rod_scale.h"
#include "words/meaning.h"

#include <QJsonArray>
#include <QJsonObject>

namespace codewheel {

// The language-neutral schema of --json, which docs/command-line.md documents: numbers are numbers, words are
// strings of eight hexadecimal digits, everything that has a name is told by its key.
QJsonValue wordJson(Word word);
QJsonValue numberJson(std::optional<std::int64_t> number); // null where there is none
// Of what cannot be 0, with 0 for what is not known; null then.
QJsonValue knownJson(std::int64_t number);
// null where the position or the scale of the rod is not known
QJsonValue millimetresJson(std::optional<std::int64_t> position, const std::optional<RodScale> &scale);
QJsonArray meaningsJson(const Explanation &explanation);
QJsonObject errorJson(const Complaint &complaint);
QJsonArray argumentsJson(const std::vector<RefusalArgument> &arguments);
// What the bus tells of a device, and the key of its description (null: not known); null without one.
QJsonValue participantJson(const Participant *participant);
// {"parameter", "value", "choice", "unit"}; choice only where the value has a name.
QJsonObject valueJson(const ParameterDescription &parameter, std::int64_t value);

// "known" and "evidence", null where nothing is known.
void addKnown(QJsonObject &json, const std::optional<Known> &known);
QJsonValue evidenceJson(const std::optional<Known> &known);
QJsonValue textJson(const QString &text); // null where it is empty
// What `more` has stands in `into` from now on.
void merge(QJsonObject &into, const QJsonObject &more);

QString unitKey(Unit unit);
QString evidenceKey(Evidence evidence);
QString stateKey(EncoderState state);
QJsonValue modeJson(std::optional<Mode> mode); // null where it is not known

} // namespace codewheel
