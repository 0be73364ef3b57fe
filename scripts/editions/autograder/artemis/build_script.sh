#!/usr/bin/env bash
# Artemis stops a build after two minutes, unless its administrator allows more: change both.
/autograder/source/run_autograder artemis --time-limit 110
