#!/bin/bash
#SBATCH --job-name=bioprint
#SBATCH --array=1-8
#SBATCH --cpus-per-task=1
#SBATCH --time=00:10:00
# A batch in eight pieces, one a task:   sbatch slurm-array.sh runs.csv
# When all are done:                     join-pieces.sh runs.piece-*.csv > answers.csv
# which says when a piece is missing or there twice.
set -euo pipefail
batch=$1
task=$SLURM_ARRAY_TASK_ID
pieces=$SLURM_ARRAY_TASK_COUNT
piece="${batch%.csv}.piece-$task-of-$pieces.csv"
status=0
bioprint-predict -q --batch "$batch" --shard "$task/$pieces" \
    --jobs "${SLURM_CPUS_PER_TASK:-1}" --output "$piece" || status=$?
# 6: some rows have no answer and say why in their place; the piece is whole.
((status == 0 || status == 6)) || exit "$status"
