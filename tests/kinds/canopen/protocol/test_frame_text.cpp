// SPDX-License-Identifier: GPL-3.0-or-later
// What frames say, from their literal bytes.
#include "can/can_log_reader.h"
#include "kinds/canopen/protocol/canopen_explain.h"

#include <gtest/gtest.h>
#include <vector>

namespace codewheel::canopen {
namespace {

// As in a log: "605#4004600000000000".
std::string said(const std::string &frame, const FrameMeaning &meaning = frameMeaning())
{
    std::string text = "not read";
    CanLogReader reader(
        [&](const CanFrame &read) {
            const FrameText told = meaning(read);
            text = told ? told().toStdString() : std::string();
        },
        [](std::int64_t, CanLogFault) {});
    reader.read("(1544106679.4) can0 " + frame + '\n');
    return text;
}

struct SaidRow
{
    const char *frame;
    const char *text;
};

const SaidRow saidRows[] = {
    // NMT
    {"000#0105", "NMT: start node 5"},
    {"000#0200", "NMT: stop all nodes"},
    {"000#8005", "NMT: node 5 to pre-operational"},
    {"000#8100", "NMT: reset all nodes"},
    {"000#8205", "NMT: reset the communication of node 5"},
    {"000#5505", "NMT: unknown command 55h to node 5"},
    {"000#01C8", "NMT: start node 200, which no node has"},
    {"000#557F", "NMT: unknown command 55h to node 127"},
    {"000#01", "NMT: of an unexpected length (bytes: 1)"},
    // SYNC and TIME
    {"080#", "SYNC"},
    {"080#07", "SYNC 7"},
    {"080#R", "SYNC: asked for by a remote frame"},
    {"100#R6", "TIME: asked for by a remote frame"},
    {"100#D8B61D03D631", "TIME 2018-12-06 14:31:19.000"},
    {"100#00", "TIME"},
    // EMCY
    {"085#3081110000000000",
     "Node 5: EMCY 8130h, guarding or heartbeat; error register: error, communication"},
    {"085#0000000000000000", "Node 5: EMCY 0000h, error gone"},
    {"085#1042080000000000", "Node 5: EMCY 4210h, temperature; error register: temperature"},
    {"085#01FF000000000000", "Node 5: EMCY FF01h, of the maker"},
    {"085#00B0000000000000", "Node 5: EMCY B000h"},
    // PDO
    {"185#88130000", "Node 5: TPDO1"},
    {"2FF#", "Node 127: TPDO2"},
    {"205#00", "Node 5: RPDO1"},
    {"185#R", "Node 5: TPDO1?"},
    // SDO
    {"605#4004600000000000", "Node 5: read 6004h:0"},
    {"585#4304600088130000", "Node 5: 6004h:0 = 1388h = 5000"},
    {"605#2303600000000000", "Node 5: write 6003h:0 = 0h = 0"},
    {"585#6003600000000000", "Node 5: 6003h:0 written"},
    {"585#8004600300000206", "Node 5: 6004h:3 aborted, 06020000h: There is no such object."},
    {"585#8004600311223344", "Node 5: 6004h:3 aborted, 44332211h"},
    {"605#2310100173617665", "Node 5: write 1010h:1 = 65766173h = 1702257011"},
    {"605#2F00620011000000", "Node 5: write 6200h:0 = 11h = 17"},
    {"585#4108100008000000", "Node 5: 1008h:0 follows in segments, 8 bytes in all"},
    {"605#6000000000000000", "Node 5: next segment"},
    {"585#0054574B2D54524E", "Node 5: segment (bytes: 7)"},
    {"585#1D34000000000000", "Node 5: last segment (bytes: 1)"},
    {"605#2108100008000000", "Node 5: write 1008h:0 in segments, 8 bytes in all"},
    {"585#2000000000000000", "Node 5: segment taken"},
    {"605#A108100008000000", "Node 5: block transfer"},
    {"605#E000000000000000", "Node 5: SDO request"},
    // what may be data of a block transfer
    {"585#8154574B2D54524E", "Node 5: SDO answer"},
    {"585#9F04600300000206", "Node 5: SDO answer"},
    {"585#6154574B2D54524E", "Node 5: SDO answer"},
    {"585#7003600000000000", "Node 5: SDO answer"},
    {"585#2154574B2D54524E", "Node 5: SDO answer"},
    {"585#5304600088130000", "Node 5: SDO answer"},
    {"605#8154574B2D54524E", "Node 5: SDO request"},
    {"605#6254574B2D54524E", "Node 5: SDO request"},
    {"605#4154574B2D54524E", "Node 5: SDO request"},
    {"605#3303600000000000", "Node 5: SDO request"},
    {"605#7000000000000000", "Node 5: next segment"},
    {"585#3000000000000000", "Node 5: segment taken"},
    {"605#8008100000000405", "Node 5: 1008h:0 aborted, 05040000h: The transfer timed out."},
    {"605#40046000", "Node 5: of an unexpected length (bytes: 4)"},
    // boot-up, heartbeat, guarding
    {"705#00", "Node 5: boot-up"},
    {"705#04", "Node 5: stopped"},
    {"705#05", "Node 5: operational"},
    {"705#7F", "Node 5: pre-operational"},
    {"705#FF", "Node 5: pre-operational (guarding, toggle bit 1)"},
    {"705#33", "Node 5: unknown state 33h"},
    {"705#R", "Node 5: guarding: which state?"},
    // LSS
    {"7E5#0401000000000000", "LSS: all devices to configuration"},
    {"7E5#0400000000000000", "LSS: all devices back to operation"},
    {"7E5#1105000000000000", "LSS: node number 5"},
    {"7E5#0402000000000000", "LSS: all devices to unknown mode 2"},
    {"7E5#11C8000000000000", "LSS: node number 200, which no node has"},
    {"7E5#1100000000000000", "LSS: node number 0, which no node has"},
    {"7E5#11FF000000000000", "LSS: no node number"},
    {"7E4#1100000000000000", "LSS answer: node number taken"},
    {"7E4#1101000000000000", "LSS answer: node number refused: out of range"},
    {"7E5#1300030000000000", "LSS: rate 250 kBit/s"},
    {"7E5#1300050000000000", "LSS: rate 5 of table 0"},
    {"7E4#1301000000000000", "LSS answer: rate refused: not supported"},
    {"7E5#15F4010000000000", "LSS: change to the new rate, waiting 500 ms before and after"},
    {"7E5#1700000000000000", "LSS: store"},
    {"7E4#1700000000000000", "LSS answer: stored"},
    {"7E4#1702000000000000", "LSS answer: not stored: the memory failed"},
    {"7E5#400D010000000000", "LSS: select: vendor 10Dh"},
    {"7E5#4378563412000000", "LSS: select: serial number 12345678h"},
    {"7E4#4400000000000000", "LSS answer: selected"},
    {"7E5#5100000000800000", "LSS: fast scan: who has no node number?"},
    {"7E5#51000000801F0303", "LSS: fast scan: serial number 80000000h, from bit 31 on?"},
    {"7E4#4F00000000000000", "LSS answer: a device is meant"},
    {"7E5#5A00000000000000", "LSS: which vendor?"},
    {"7E4#5A0D010000000000", "LSS answer: vendor 10Dh"},
    {"7E4#5D78563412000000", "LSS answer: serial number 12345678h"},
    {"7E4#5EFF000000000000", "LSS answer: no node number"},
    {"7E5#9900000000000000", "LSS: unknown command 99h"},
    // what is not in the predefined connection set, or not of 11 bits
    {"7FF#00", ""},
    {"180#00", ""},
    {"00000185#00", ""},
    {"20000080#0000000000000000", ""},
};

TEST(CanopenFrameText, WhatAFrameSays)
{
    for (const SaidRow &row : saidRows)
        EXPECT_EQ(said(row.frame), row.text) << row.frame;
}

// One after the other.
void expectSaid(const std::vector<SaidRow> &rows)
{
    const FrameMeaning meaning = frameMeaning();
    for (const SaidRow &row : rows)
        EXPECT_EQ(said(row.frame, meaning), row.text) << row.frame;
}

TEST(CanopenFrameText, PdosHaveTheValuesThatANodeWasHeardToMap)
{
    expectSaid({
        {"185#881300000A00", "Node 5: TPDO1"},
        {"585#4300180185010000", "Node 5: 1800h:1 = 185h = 389"},
        {"585#4F001A0002000000", "Node 5: 1A00h:0 = 2h = 2"},
        {"585#43001A0120000460", "Node 5: 1A00h:1 = 60040020h = 1610874912"},
        {"185#88130000F6FF", "Node 5: TPDO1"}, // not all of it was heard
        {"585#43001A0210013060", "Node 5: 1A00h:2 = 60300110h = 1613758736"},
        {"185#88130000F6FF", "Node 5: TPDO1, 6004h:0 = 1388h = 5000, 6030h:1 = FFF6h = -10"},
        {"185#8813", "Node 5: TPDO1"}, // shorter than its mapping
        // written, and taken
        {"605#2300180190010000", "Node 5: write 1800h:1 = 190h = 400"},
        {"585#8000180120000008",
         "Node 5: 1800h:1 aborted, 08000020h: The value cannot be transferred or stored."},
        {"190#88130000F6FF", "Node 16: TPDO1"},
        {"605#2300180190010000", "Node 5: write 1800h:1 = 190h = 400"},
        {"585#6000180100000000", "Node 5: 1800h:1 written"},
        {"190#88130000F6FF", "Node 5: TPDO1, 6004h:0 = 1388h = 5000, 6030h:1 = FFF6h = -10"},
        // another node; a node that starts anew
        {"186#88130000F6FF", "Node 6: TPDO1"},
        {"705#00", "Node 5: boot-up"},
        {"190#88130000F6FF", "Node 16: TPDO1"},
    });
}

TEST(CanopenFrameText, DataOfABlockDownloadIsNotTakenForCommands)
{
    expectSaid({
        {"605#C600620010000000", "Node 5: block transfer"},
        {"585#A400620003000000", "Node 5: block transfer"},
        {"606#0101020304050607", "Node 6: last segment (bytes: 7)"},
        {"605#0101020304050607", "Node 5: block segment (1)"},
        {"605#0201020304050607", "Node 5: block segment (2)"},
        {"605#0301020304050607", "Node 5: block segment (3)"},
        {"585#A203020000000000", "Node 5: block transfer"},
        {"605#8101020000000000", "Node 5: last block segment (1)"},
        {"585#A201020000000000", "Node 5: block transfer"},
        {"605#D512340000000000", "Node 5: block transfer"},
        {"585#A100000000000000", "Node 5: block transfer"},
        {"605#4004600000000000", "Node 5: read 6004h:0"},
        {"605#0101020304050607", "Node 5: last segment (bytes: 7)"},
    });
}

TEST(CanopenFrameText, DataOfABlockUploadIsNotTakenForCommands)
{
    expectSaid({
        {"605#A408100041000000", "Node 5: block transfer"},
        {"585#C608100000020000", "Node 5: block transfer"},
        {"605#A300000000000000", "Node 5: block transfer"},
        {"585#0154574B2D54524E", "Node 5: block segment (1)"},
        {"585#8234574B2D54524E", "Node 5: last block segment (2)"},
        {"605#A201410000000000", "Node 5: block transfer"}, // the second one did not arrive
        {"585#8134574B2D54524E", "Node 5: last block segment (1)"},
        {"605#A201410000000000", "Node 5: block transfer"},
        {"585#C100000000000000", "Node 5: block transfer"},
        {"605#A100000000000000", "Node 5: block transfer"},
        {"585#4304600088130000", "Node 5: 6004h:0 = 1388h = 5000"},
    });
}

TEST(CanopenFrameText, WhereASegmentIsMissingOrItIsAbortedABlockTransferIsOver)
{
    for (const SaidRow &end :
         {SaidRow{"585#4304600088130000", "Node 5: 6004h:0 = 1388h = 5000"},
          SaidRow{"585#8008100000000405", "Node 5: 1008h:0 aborted, 05040000h: The transfer timed out."},
          SaidRow{"605#4004600000000000", "Node 5: read 6004h:0"}})
        expectSaid({{"605#A300000000000000", "Node 5: block transfer"},
                    end,
                    {"585#0154574B2D54524E", "Node 5: last segment (bytes: 7)"}});
}

} // namespace
} // namespace codewheel::canopen
