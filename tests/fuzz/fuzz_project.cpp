// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are a project, or are refused with a sentence; what is read can be saved, and is the same when
// read again.
#include "project/project_json.h"
#include "tests/fuzz/must.h"
#include "vocabulary/refusal_text.h"

using namespace codewheel;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    const QString name = QStringLiteral("fuzz.codewheel");
    const auto project = projectFromJson(bytes, name);
    if (!project) {
        must(refusalText(project.error()).startsWith(name), "the sentence names the file");
        return 0;
    }
    const QByteArray saved = projectToJson(*project);
    const auto again = projectFromJson(saved, name);
    must(again.has_value(), "what was saved can be read");
    must(*again == *project, "what was saved is the same");
    must(projectToJson(*again) == saved, "it gives the same bytes");
    return 0;
}
