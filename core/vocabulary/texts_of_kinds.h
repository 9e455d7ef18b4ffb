// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/message.h"
#include "vocabulary/training_act.h"

#include <QStringList>

#include <optional>
#include <span>

// Texts about what only one kind can read, and the families of refusals and messages. kinds/protocols.cpp has
// them.
namespace codewheel {

// The arguments of a refusal of an OUT word, and behind the word what it does in cam mode: "sets the start of
// cam 0 to 0". Without a word, what a preset does.
QStringList textsWithCamEffect(const std::vector<RefusalArgument> &arguments);
// What was done to a simulated bus, in a sentence; nothing: no kind knows its key.
std::optional<QString> textOfTrainingAct(const TrainingAct &act);
// What was typed on a line and written, from its text and the fraction bits of a scaling factor: "05: set
// preset to 1770h = 6000 (05GP00001770)". A text of an earlier version is shown as it is.
QString textOfTyped(const std::vector<RefusalArgument> &typed);

// Those of kinds/protocols.cpp, and any that were added, before a journal is read.
std::span<const RefusalFamily *const> refusalFamilies();
std::span<const MessageFamily *const> messageFamilies();
void addRefusals(const RefusalFamily &family);
void addMessages(const MessageFamily &family);

} // namespace codewheel
