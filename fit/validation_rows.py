"""Write data/validation_rows.csv: which rows of the training files are kept for validation (`common.split`).

python3 validation_rows.py

The split is a permutation of numpy's generator; the Rust tests read the list. `row` counts from 0 after the header.
"""

import os

import common
import numpy as np

FILES = ("train.csv", "train_fine.csv")


def main():
    counts = [len(common.read(name)["nu"]) for name in FILES]
    data = {
        "g": np.concatenate([common.read(name)["a_over_b"] for name in FILES]),
        "file": np.repeat(np.arange(len(FILES)), counts),
        "row": np.concatenate([np.arange(count) for count in counts]),
    }
    validation = common.split(data)[1]
    rows = sorted(zip(validation["file"], validation["row"]))
    with open(os.path.join(common.DATA, "validation_rows.csv"), "w", encoding="utf-8") as file:
        file.write("file,row\n" + "".join(f"{FILES[k]},{row}\n" for k, row in rows))
    print(f"{len(rows)} of {sum(counts)} rows")


if __name__ == "__main__":
    main()
