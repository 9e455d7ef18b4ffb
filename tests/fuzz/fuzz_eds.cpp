// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are a device file or refused with a sentence; its objects are in order and each is there once.
// The DCF that is written of it is read again.
#include "kinds/canopen/eds/compare_files.h"
#include "kinds/canopen/eds/dcf_writer.h"
#include "kinds/canopen/eds/device_file_reader.h"
#include "tests/fuzz/must.h"

#include <algorithm>

using namespace codewheel;
using namespace codewheel::canopen;

namespace {

void checkNotes(const std::vector<EdsNote> &notes)
{
    for (const EdsNote &note : notes) {
        must(note.line >= 0, "lines are counted");
        must(!note.text().isEmpty(), "there is a sentence");
    }
}

void checkObject(const FileObject &object)
{
    must(!object.name.isEmpty(), "it has a name");
    for (const auto *value : {&object.factory, &object.minimum, &object.maximum, &object.value})
        if (*value && (*value)->number() != nullptr && object.type && isNumber(*object.type)) {
            const ReadValue again = readFileValue((*value)->text(object.type).toStdString(), object.type);
            must(again.value == *value, "a number that is written is read");
        }
}

DeviceFile readAgain(const DeviceFile &file)
{
    const auto again = readDeviceFile(dcfOf(file, {.fileName = QStringLiteral("a.dcf"), .now = {}}));
    must(again.has_value(), "what is written is read");
    must(again->refused.empty(), "node and rate are allowed ones");
    must(again->objects.size() == file.objects.size(), "all objects are there");
    must(again->commissioning.node == file.commissioning.node, "the node is the same");
    must(again->commissioning.rate == file.commissioning.rate, "the rate is the same");
    return *again;
}

// The first time texts lose what cannot be in a line, and values are left out.
void checkWritten(const DeviceFile &file)
{
    const DeviceFile once = readAgain(file);
    for (std::size_t i = 0; i < file.objects.size(); ++i) {
        const FileObject &object = file.objects[i];
        must(once.objects[i].object == object.object && once.objects[i].type == object.type,
             "the same object");
        const bool isNumber = object.factory && object.factory->number() != nullptr;
        must(!isNumber || once.objects[i].factory == object.factory, "numbers stay the same");
    }
    must(compareFiles(once, readAgain(once)).empty(), "from then on it stays the same");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const auto file = readDeviceFile(
        QByteArray::fromRawData(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size)));
    if (!file) {
        checkNotes({file.error()});
        return 0;
    }
    checkNotes(file->notes.kept());
    checkNotes(file->refused);
    const auto order = [](const FileObject &object) { return orderOf(object.object); };
    must(std::ranges::is_sorted(file->objects, {}, order), "in order");
    must(std::ranges::adjacent_find(file->objects, {}, order) == file->objects.end(), "each once");
    std::ranges::for_each(file->objects, checkObject);
    checkWritten(*file);
    const Commissioning &its = file->commissioning;
    must(!its.node || (*its.node >= 1 && *its.node <= 127), "a node has a number of CANopen");
    must(!its.rate || *its.rate >= 10'000, "a rate is in Bd");
    return 0;
}
