// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/fraba_appendix.h"

namespace codewheel {
namespace {

using enum MeaningId;
using enum Happening;
using enum WordDirection;

constexpr Mode cam = Mode::cam;
constexpr Meaning at12345{position, {12345}};

// FRABA manual 5.4.4: cam 3 of program 1 is on from 15h to 213h; beside it the position shifted by 8
const std::vector<Word> cam3{0x2080'0001, 0x4600'0015, 0x6600'0213, 0x2040'0008, 0x2010'0008, 0x8000'0000};
const std::vector<Word> camMode1{0x2080'0001};
// 1 step per turn: the largest position is 4095
const std::vector<Word> camMode4096{0x0200'0001, 0x8000'0000, 0x2080'0001};
const std::vector<Word> preset100{0x0800'0064, 0x8000'0000, 0x0000'0000};

// clang-format off
const AppendixRow appendixRows[] = {
    {"10.1", "Normal running", "0xxxxxxx", out, Mode::position, nothing, {},
     0x0000'0000, 0x0000'3039, {normalRunning}, at12345, "Normal running", "Running, position 12345"},
    {"10.1", "Normal running", "0xxxxxxx", out, Mode::position, nothing, {},
     0x01AB'CDEF, 0x0000'3039, {normalRunningData, {0x1AB'CDEF}}, at12345,
     "Normal running; the data 28036591 mean nothing", "Running, position 12345"},
    {"10.1", "run!", "80000000", out, Mode::position, nothing, {0x0200'00FF},
     0x8000'0000, 0x0000'0180, {run}, {position, {0x180}}, "Run", "Running, position 384"},
    {"10.1", "set presetvalue", "40000000", out, Mode::position, nothing, preset100,
     0x4000'0000, 0x0000'0064, {initialisePreset}, {position, {100}},
     "Initialise the preset", "Running, position 100"},
    {"10.1", "subparameter steps", "02xxxxxx", out, Mode::position, nothing, {},
     0x0200'00FF, 0xC200'00FF, {parameterRequest, {1, 255}}, {confirmed, {1, 255}},
     "Parameter 1 steps = 255", "Parameter 1 steps = 255 confirmed"},
    {"10.1", "subparameter turns", "04xxxxxx", out, Mode::position, nothing, {},
     0x0400'0001, 0xC400'0001, {parameterRequest, {2, 1}}, {confirmed, {2, 1}},
     "Parameter 2 revolutions = 1", "Parameter 2 revolutions = 1 confirmed"},
    {"10.1", "direction", "06xxxxxx", out, Mode::position, nothing, {},
     0x0600'0003, 0xC600'0003, {parameterRequest, {3, 3}}, {confirmed, {3, 3}},
     "Parameter 3 direction = 3 (CW)", "Parameter 3 direction = 3 (CW) confirmed"},
    {"10.1", "presetvalue", "08xxxxxx", out, Mode::position, nothing, {},
     0x0800'0064, 0xC800'0064, {parameterRequest, {4, 100}}, {confirmed, {4, 100}},
     "Parameter 4 preset = 100", "Parameter 4 preset = 100 confirmed"},
    {"10.1", "activate zero point shifting", "0Axxxxxx", out, Mode::position, nothing, {},
     0x0A00'000A, 0xCA00'000A, {parameterRequest, {5, 10}}, {confirmed, {5, 10}},
     "Parameter 5 zero offset = 10", "Parameter 5 zero offset = 10 confirmed"},
    {"10.1", "set encoder to default (!)", "0E000000", out, Mode::position, nothing, {},
     0x0E00'0000, 0xCE00'0000, {resetToDefault}, {confirmed, {7, 0}},
     "Reset to factory settings", "Parameter 7 = 0 (reset to factory settings) confirmed"},

    {"10.2", "FRABA Preset", "60000000", out, Mode::position, nothing, preset100,
     0x6000'0000, 0x0000'0064, {frabaPreset}, {position, {100}},
     "FRABA preset: activate the preset in every cycle", "Running, position 100"},
    {"10.2", "velocity start", "20400001", out, Mode::velocity, turnsAt1500Rpm, {},
     0x2040'0001, 0x0000'05DC, {velocityOn}, {velocity, {1500}}, "Velocity mode on", "Running, speed 1500 rpm"},
    {"10.2", "velocity stop", "20400000", out, Mode::position, nothing, {0x2040'0001},
     0x2040'0000, 0x0000'3039, {velocityOff}, at12345, "Velocity mode off", "Running, position 12345"},
    {"10.2", "serial number", "20210000", out, Mode::position, nothing, {},
     0x2021'0000, 0xA000'1267, {readOutRequest, {0}}, {readOutValue, {0, 4711}},
     "Read out serial number", "Read-out: serial number = 4711 (1267h)"},
    {"10.2", "steps", "20210001", out, Mode::position, nothing, {},
     0x2021'0001, 0xA000'2000, {readOutRequest, {1}}, {readOutValue, {1, 8192}},
     "Read out steps", "Read-out: steps = 8192"},
    {"10.2", "revolutions", "20210002", out, Mode::position, nothing, {},
     0x2021'0002, 0xA000'0001, {readOutRequest, {2}}, {readOutValue, {2, 1}},
     "Read out revolutions", "Read-out: revolutions = 1"},
    {"10.2", "complement", "20210003", out, Mode::position, nothing, {0x0600'0004, 0x8000'0000, 0x0000'0000},
     0x2021'0003, 0xA000'0004, {readOutRequest, {3}}, {readOutValue, {3, 4}},
     "Read out direction", "Read-out: direction = 4 (CCW)"},
    {"10.2", "preset", "20210004", out, Mode::position, nothing, preset100,
     0x2021'0004, 0xA000'0064, {readOutRequest, {4}}, {readOutValue, {4, 100}},
     "Read out preset", "Read-out: preset = 100"},
    {"10.2", "zero point shifting", "20210005", out, Mode::position, nothing, {0x0A00'000A, 0x8000'0000, 0x0000'0000},
     0x2021'0005, 0xA000'000A, {readOutRequest, {5}}, {readOutValue, {5, 10}},
     "Read out zero offset", "Read-out: zero offset = 10"},
    {"10.2", "preset_flag", "20210006", out, Mode::position, nothing, preset100,
     0x2021'0006, 0xA000'0001, {readOutRequest, {6}}, {readOutValue, {6, 1}},
     "Read out preset flag", "Read-out: preset flag = 1 (preset programmed, not activated)"},
    {"10.2", "software version", "20210007", out, Mode::position, nothing, {},
     0x2021'0007, 0xA000'0103, {readOutRequest, {7}}, {readOutValue, {7, 0x103}},
     "Read out software version", "Read-out: software version = 259"},
    {"10.2", "operating time [10 min]", "20210008", out, Mode::position, nothing, {},
     0x2021'0008, 0xA000'0063, {readOutRequest, {8}}, {readOutValue, {8, 99}},
     "Read out operating time", "Read-out: operating time = 16.5 h"},
    {"10.2", "startup_mode", "20210009", out, Mode::position, nothing, {},
     0x2021'0009, 0xA000'0001, {readOutRequest, {9}}, {readOutValue, {9, 1}},
     "Read out start-up mode", "Read-out: start-up mode = 1 (position, as K3)"},
    {"10.2", "startup_mode", "20210009", out, Mode::velocity, nothing, {0x2040'0001},
     0x2021'0009, 0xA000'0002, {readOutRequest, {9}}, {readOutValue, {9, 2}},
     "Read out start-up mode", "Read-out: start-up mode = 2 (velocity)"},
    {"10.2", "startup_mode", "20210009", out, cam, nothing, {0x2080'0008},
     0x2021'0009, 0xA000'000A, {readOutRequest, {9}}, {readOutValue, {9, 10}},
     "Read out start-up mode", "Read-out: start-up mode = 10 (cam program 8)"},
    {"10.2", "flag_mt_stepsm1", "2021000A", out, Mode::position, nothing, {},
     0x2021'000A, 0xA000'0002, {readOutRequest, {10}}, {readOutValue, {10, 2}},
     "Read out multi-turn and steps minus 1", "Read-out: multi-turn and steps minus 1 = 2 (multi-turn)"},
    {"10.2", "temperature [Celsius/10]", "2021000C", out, Mode::position, nothing, {},
     0x2021'000C, 0xA000'00F5, {readOutRequest, {12}}, {readOutValue, {12, 245}},
     "Read out temperature", "Read-out: temperature = 24.5 °C"},
    {"10.2", "read out OPC-register", "202100xD", out, Mode::position, nothing, {},
     0x2021'003D, 0xA000'0000, {opcRegisterRequest, {3}}, {opcRegisterValue, {3, 0}},
     "Read out register 3 of the bus chip", "Read-out: register 3 of the bus chip = 00000000"},
    {"10.2", "read out stop", "xx0xxxxx", out, Mode::position, nothing, {0x2021'0001},
     0x0000'0000, 0x0000'3039, {normalRunning}, at12345, "Normal running", "Running, position 12345"},
    {"10.2", "read out stop", "xx0xxxxx", out, Mode::position, nothing, {0x2021'0001},
     0x0200'00FF, 0xC200'00FF, {parameterRequest, {1, 255}}, {confirmed, {1, 255}},
     "Parameter 1 steps = 255", "Parameter 1 steps = 255 confirmed"},

    {"10.3", "no valid position value is given out", "8xxxxxxx", in, Mode::position, turnsAt6000Rpm, {},
     0x0000'0000, 0x8000'0000, {normalRunning}, {noValidPosition}, "Normal running", "No valid position"},
    {"10.3", "wrong parameter data", "82000000", in, Mode::position, nothing, {},
     0x0200'0000, 0x8200'0000, {parameterRequest, {1, 0}}, {deviceError, {1, 0}},
     "Parameter 1 steps = 0", "Error 1: wrong parameter data"},
    {"10.3", "wrong parameter data", "82000000", in, Mode::position, nothing, {0x0200'2328}, // 9000 steps a turn
     0x8000'0000, 0x8200'0000, {run}, {deviceError, {1, 0}}, "Run", "Error 1: wrong parameter data"},
    {"10.3", "unknown parameter number", "84000000", in, Mode::position, nothing, {},
     0x0C00'0001, 0x8400'0000, {parameterRequest, {6, 1}}, {deviceError, {2, 0}},
     "Parameter 6 (not defined for this encoder) = 1", "Error 2: unknown parameter number"},
    {"10.3", "parameters lost", "86000000", in, Mode::position, losesItsParameters, {},
     0x0000'0000, 0x8600'0000, {normalRunning}, {deviceError, {3, 0}},
     "Normal running", "Error 3: parameters lost"},
    {"10.3", "unknown parameter (in read out)", "A4xxxxxx", in, Mode::position, nothing, {},
     0x2021'000B, 0xA400'000B, {readOutRequest, {11}}, {readOutUnknown, {11}},
     "Read out code 11, which is not defined", "The encoder does not know the read-out code 11"},
    // The manual gives only one such code, that of 10.6.
    {"10.3", "manufacturer specific error code", "980000xx", in, cam, nothing, camMode4096,
     0x4000'1000, 0x9800'0004, {camStart, {0, 4096}}, {manufacturerError, {4}},
     "Start of cam 0 = 4096", "Manufacturer's error 4: cam start or stop above the largest position"},

    {"10.4", "normal running", "0xxxxxxx", in, Mode::position, nothing, {},
     0x0000'0000, 0x0000'3039, {normalRunning}, at12345, "Normal running", "Running, position 12345"},
    {"10.4", "processing parameter", "Cxxxxxxx", in, Mode::position, startsUp, {},
     0x0000'0000, 0xC000'0000, {normalRunning}, {processing, {0}}, "Normal running", "Processing, data 0"},
    {"10.4", "parameter received(not checked yet)", "Cxxxxxxx", in, Mode::position, nothing, {},
     0x0200'0000, 0xC200'0000, {parameterRequest, {1, 0}}, {confirmed, {1, 0}},
     "Parameter 1 steps = 0", "Parameter 1 steps = 0 confirmed", 3}, // refused a cycle later
    {"10.4", "Read out mode or auto test", "Axxxxxxx", in, Mode::position, nothing, {},
     0x2021'0001, 0xA000'2000, {readOutRequest, {1}}, {readOutValue, {1, 8192}},
     "Read out steps", "Read-out: steps = 8192"},

    {"10.5", "Normal running", "0000xxxx", out, cam, nothing, cam3,
     0x0000'0000, 0x0000'3000, {normalRunning}, {cams, {0, 0x30}},
     "Normal running", "Running, cams on: none, position part 48"},
    {"10.5", "run/exit cam-parameterization mode", "80000000", out, cam, nothing, {0x2080'0001, 0x4600'0015},
     0x8000'0000, 0x0030'3900, {run}, {cams, {0, 0x3039}},
     "Run", "Running, cams on: none, position part 12345"},
    {"10.5", "set encoder to cam mode, program no. x", "2080000x", out, cam, nothing, {},
     0x2080'0001, 0x0030'3900, {camMode, {1}}, {cams, {0, 0x3039}},
     "Cam mode, program 1", "Running, cams on: none, position part 12345"},
    {"10.5", "set encoder to position mode", "20800000", out, Mode::position, nothing, camMode1,
     0x2080'0000, 0x0000'3039, {positionMode}, at12345, "Position mode", "Running, position 12345"},
    {"10.5", "set cam configuration", "2040xxxx", out, cam, nothing, camMode1,
     0x2040'0093, 0xE040'0093, {camConfiguration, {0x93}}, {camConfirmation, {0x2040'0093}},
     "Active cams: 0, 1, 4, 7", "Acknowledged: Active cams: 0, 1, 4, 7"},
    {"10.5", "set shift_iw", "201000xx", out, cam, nothing, camMode1,
     0x2010'0019, 0xE010'0019, {setCamShift, {25}}, {camConfirmation, {0x2010'0019}},
     "Position beside the cams shifted by 25", "Acknowledged: Position beside the cams shifted by 25"},
    {"10.5", "set start value for a cam", "4xxxxxxx", out, cam, nothing, camMode1,
     0x4600'0015, 0xC600'0015, {camStart, {3, 0x15}}, {camConfirmation, {0x4600'0015}},
     "Start of cam 3 = 21", "Acknowledged: Start of cam 3 = 21"},
    {"10.5", "set end value for a cam", "6xxxxxxx", out, cam, nothing, camMode1,
     0x6600'0213, 0xE600'0213, {camStop, {3, 0x213}}, {camConfirmation, {0x6600'0213}},
     "Stop of cam 3 = 531", "Acknowledged: Stop of cam 3 = 531"},
    {"10.5", "read out cam configuration", "20200000", out, cam, nothing, cam3,
     0x2020'0000, 0xA000'0008, {camConfigurationRequest}, {camConfigurationValue, {8}},
     "Read out the active cams", "Read-out: active cams 3"},
    {"10.5", "read out start value for a cam", "2020001x", out, cam, nothing, cam3,
     0x2020'0013, 0xA000'0015, {camStartRequest, {3}}, {camStartValue, {3, 0x15}},
     "Read out the start of cam 3", "Read-out: start of cam 3 = 21"},
    {"10.5", "read out end value for a cam", "2020002x", out, cam, nothing, cam3,
     0x2020'0023, 0xA000'0213, {camStopRequest, {3}}, {camStopValue, {3, 0x213}},
     "Read out the stop of cam 3", "Read-out: stop of cam 3 = 531"},
    // The hexadecimal column has 20200030; the row's bits, and 5.4.4, have 20200040.
    {"10.5", "readout shift_iw-value", "20200040", out, cam, nothing, cam3,
     0x2020'0040, 0xA000'0008, {camShiftRequest}, {camShiftValue, {8}},
     "Read out the shift of the position beside the cams",
     "Read-out: position beside the cams shifted by 8"},
    {"10.5", "readout shift_iw-value", "20200030", out, cam, nothing, cam3,
     0x2020'0030, 0xA400'0030, {camShiftRequest}, {readOutUnknown, {0x30}},
     "Read out the shift of the position beside the cams",
     "The encoder does not know the read-out code 48"},

    {"10.6", "no valid cam value is given out", "8xxxxxxx", in, cam, turnsAt6000Rpm, camMode1,
     0x0000'0000, 0x8000'0000, {normalRunning}, {noValidPosition}, "Normal running", "No valid position"},
    {"10.6", "wrong parameter data", "82000000", in, cam, nothing, camMode1,
     0x2010'001A, 0x8200'0000, {setCamShift, {26}}, {deviceError, {1, 0}},
     "Position beside the cams shifted by 26 (there are only 0 to 25)", "Error 1: wrong parameter data"},
    {"10.6", "wrong parameter data", "82000000", in, cam, nothing, camMode1,
     0x2080'0009, 0x8200'0000, {camMode, {9}}, {deviceError, {1, 0}},
     "Cam mode, program 9 (there are only 1 to 8)", "Error 1: wrong parameter data"},
    {"10.6", "wrong command", "84000000", in, cam, nothing, camMode1,
     0x0200'00FF, 0x8400'0000, {parameterRequestInCamMode, {1, 255}}, {wrongCamCommand, {0}},
     "Parameter 1 steps = 255: refused in cam mode", "Error 2: wrong cam command"},
    {"10.6", "parameters lost", "86000000", in, cam, losesItsParameters, camMode1,
     0x0000'0000, 0x8600'0000, {normalRunning}, {deviceError, {3, 0}},
     "Normal running", "Error 3: parameters lost"},
    {"10.6", "manufacturer specific error code", "980000xx", in, cam, nothing, camMode4096,
     0x6000'1000, 0x9800'0004, {camStop, {0, 4096}}, {manufacturerError, {4}},
     "Stop of cam 0 = 4096", "Manufacturer's error 4: cam start or stop above the largest position"},
    {"10.6", "Cam-start/stop-value higher than max. position value", "98000004", in, cam, nothing, camMode4096,
     0x4E00'1000, 0x9800'0004, {camStart, {7, 4096}}, {manufacturerError, {4}},
     "Start of cam 7 = 4096", "Manufacturer's error 4: cam start or stop above the largest position"},
};
// clang-format on

} // namespace

std::span<const AppendixRow> frabaAppendix()
{
    return appendixRows;
}

} // namespace codewheel
