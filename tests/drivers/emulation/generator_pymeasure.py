#!/usr/bin/env python3
"""generator_pymeasure.py PORT STEP: PyMeasure's driver of the Agilent 33500, through PyVISA-py, sets
the generator on 127.0.0.1:PORT and prints what it reads back."""
import sys

import pyvisa
from pymeasure.adapters import VISAAdapter
from pymeasure.instruments.agilent import Agilent33500


def sine(generator):
    generator.output_load = "INF"
    generator.shape = "SIN"
    generator.frequency = 50.0
    generator.amplitude = 2.5
    generator.offset = 0.25
    generator.output = True
    print(generator.shape, generator.frequency, generator.amplitude, generator.offset, generator.output)


def burst(generator):
    generator.burst_mode = "TRIG"
    generator.burst_ncycles = 3
    generator.trigger_source = "BUS"
    generator.burst_state = True
    print(generator.burst_mode, generator.burst_ncycles, generator.trigger_source, generator.burst_state)
    generator.trigger()
    generator.wait_for_trigger(timeout=20)
    print("triggered")


def arbitrary(generator):
    generator.data_volatile_clear()
    generator.data_arb("ramp", range(-10000, 10000, 20), data_format="DAC")
    generator.arb_file = "ramp"
    generator.arb_srate = 8000.0
    generator.arb_filter = "OFF"
    generator.shape = "ARB"
    print(generator.shape, generator.arb_file, generator.arb_srate, generator.arb_filter)


def unhappy(generator):
    generator.arb_file = "missing"


port, step = sys.argv[1:]
print("PyVISA", pyvisa.__version__, file=sys.stderr)
adapter = VISAAdapter(
    f"TCPIP::127.0.0.1::{port}::SOCKET",
    visa_library="@py",
    read_termination="\n",
    write_termination="\n",
    timeout=10000,
)
instrument = Agilent33500(adapter)
print(*instrument.id, sep=",")
{"sine": sine, "burst": burst, "arbitrary": arbitrary, "unhappy": unhappy}[step](instrument)
for error in instrument.check_errors():
    print(error)
