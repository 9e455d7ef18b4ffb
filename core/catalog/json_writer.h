// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/value.h"

#include <QByteArray>
#include <QString>

#include <concepts>
#include <cstdint>
#include <vector>

namespace codewheel {

// Writes the JSON of our files so that the same content always gives the same bytes and two files can be
// compared line by line: one member per line, small objects of a list in one line each. Text is UTF-8.
class JsonWriter
{
public:
    JsonWriter();

    void member(const char *key, const QString &text);
    void member(const QString &key, const QString &text);
    void member(const char *key, const char *text);
    void member(const char *key, double number);
    void member(const char *key, std::integral auto number)
    {
        raw(key, QByteArray::number(static_cast<qlonglong>(number)));
    }
    void value(const char *key, const Value &value);
    // A function of its own, since a pointer would convert to bool.
    void flag(const char *key, bool on) { raw(key, on ? "true" : "false"); }

    // Calls fill() to write the members of an object.
    template <typename Fill>
    void object(const QByteArray &key, Fill fill)
    {
        begin(key, '{', Form::lines);
        fill();
        end('}');
    }
    // Calls fill(row) for each row of a list, to write the members of an object.
    template <typename Rows, typename Fill>
    void list(const char *key, const Rows &rows, Fill fill)
    {
        listOfForm(key, rows, fill, Form::lines);
    }
    // The same, each object in one line.
    template <typename Rows, typename Fill>
    void lines(const char *key, const Rows &rows, Fill fill)
    {
        listOfForm(key, rows, fill, Form::oneLine);
    }
    void texts(const char *key, const QStringList &texts); // each on its own line

    // Finishes the file; the writer cannot be used afterwards.
    QByteArray finish();

private:
    enum class Form : std::uint8_t { lines, oneLine };
    struct Level
    {
        Form form;
        bool isEmpty;
    };

    template <typename Rows, typename Fill>
    void listOfForm(const char *key, const Rows &rows, Fill fill, Form form)
    {
        begin(key, '[', Form::lines);
        for (const auto &row : rows) {
            begin({}, '{', form);
            fill(row);
            end('}');
        }
        end(']');
    }
    void raw(const QByteArray &key, const QByteArray &value);
    void begin(const QByteArray &key, char bracket, Form form);
    void end(char bracket);
    void startValue(const QByteArray &key);
    void newLine();

    QByteArray m_json;
    std::vector<Level> m_levels;
};

} // namespace codewheel
