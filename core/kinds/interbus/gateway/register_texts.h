// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

#include <QStringList>

#include <initializer_list>

// Texts about the registers of a gateway. Messages store keys, from which the texts are made where they are
// shown, in the language of that time. What is no key is shown as it is: earlier versions stored texts.
namespace codewheel {

// "4/0/28": function, first register, count.
QString registersKey(int function, int first, int count);
// "function 4, registers 0 to 27".
QString registersText(const QString &key);

// What an exception code means (Modbus Application Protocol V1.1b3, 7); a sentence.
QString exceptionText(int code);

// What can be wrong with an answer. The comment lists the numbers that belong to it.
enum class WrongAnswer : std::uint8_t {
    incomplete,        //
    damaged,           // or incomplete: nobody can tell
    notModbus,         //
    unit,              // unit
    transaction,       // transaction, that of the request
    oneTransaction,    // the transaction of each answer
    function,          // function
    length,            // bytes, those expected
    otherRegisters,    // than those to be written
    count,             // of its own bytes
    lengthOfException, //
    another,           // follows it
    noPause,           // on the line
};
QString wrongAnswerKey(WrongAnswer what, std::initializer_list<int> numbers = {});
// With what to do about it.
QString wrongAnswerText(const QString &key);

// The arguments of a refusal of registers (registersUnanswered .. outputsBlocked) for its sentence.
QStringList registerRefusalTexts(const Refusal &refusal);

} // namespace codewheel
