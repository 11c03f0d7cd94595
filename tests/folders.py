"""Where the checkout has what tests read."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SAMPLE = ROOT / "sample_assets" / "char.usda"
ASSETS = ROOT.parent / "shared" / "assets"
"""Characters that are handed out beside the checkout; they need not be there."""
