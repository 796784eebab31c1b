# SPDX-License-Identifier: MIT
"""The reference in headless Chromium, opened from files: search, keys, links, colours, small screens. Consoles stay silent (fixture ``page``)."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from browser import Browser
from schema_maker import SchemaMaker
from test_site import _NASTY

CTRL = 2

_RESULTS = """[...document.querySelectorAll('.result')].map(row => ({kind: row.querySelector('.kind').textContent, name: row.querySelector('.name').textContent,
    summary: row.querySelector('.summary').textContent, marked: [...row.querySelectorAll('mark')].map(m => m.textContent).join(' ')}))"""


def _search(page: Browser, query: str) -> list[dict[str, str]]:
    """Focuses the field by its key, types, waits for the answer."""
    page.press("/")
    page.run("document.activeElement.value = ''")
    page.type(query)
    page.wait(f"document.getElementById('ui-search').value === {json.dumps(query)} && typeof spearSearch === 'object' && spearSearch.size")
    page.wait("document.querySelectorAll('.result').length || document.getElementById('result-status').textContent.startsWith('Nothing')")
    found: list[dict[str, str]] = page.run(_RESULTS)
    return found


# Search --------------------------------------------------------------------------------------------------------------------------


def test_search_finds_a_function_and_enter_opens_its_anchor(page: Browser, engine_site: Path) -> None:
    page.open(engine_site / "index.html")
    assert page.run("document.activeElement.id") != "ui-search"
    found = _search(page, "setactorscale3d")
    assert found[0]["name"] == "AActor.SetActorScale3D" and found[0]["kind"] == "function"
    page.press("Enter")
    page.wait("location.pathname.endsWith('/Engine/AActor.html') && document.readyState === 'complete'")
    assert page.run("location.hash") == "#SetActorScale3D"
    assert page.run("document.querySelector(':target').querySelector('h3 a').textContent") == "SetActorScale3D"
    top = page.run("document.querySelector(':target').getBoundingClientRect().top")
    assert 0 <= top < 400, "the function is in view, below the header"


def test_the_slash_is_typed_where_one_types_and_control_k_works_too(page: Browser, engine_site: Path) -> None:
    page.open(engine_site / "Engine" / "AActor.html")
    page.press("k", CTRL)
    assert page.run("document.activeElement.id") == "ui-search"
    page.type("a/b")
    assert page.run("document.activeElement.value") == "a/b"


def test_arrows_choose_and_escape_closes(page: Browser, engine_site: Path) -> None:
    page.open(engine_site / "index.html")
    found = _search(page, "location")
    assert len(found) > 5
    selected = "[...document.querySelectorAll('.result')].findIndex(row => row.getAttribute('aria-selected') === 'true')"
    assert page.run(selected) == 0
    page.press("ArrowDown")
    page.press("ArrowDown")
    assert page.run(selected) == 2
    assert page.run("document.getElementById('ui-search').getAttribute('aria-activedescendant')") == "result-2"
    page.press("ArrowUp")
    assert page.run(selected) == 1
    page.press("Escape")
    assert page.run("document.getElementById('ui-results').hidden")
    page.press("Escape")
    assert page.run("document.activeElement.id") != "ui-search"
    _search(page, "location")
    page.press("ArrowDown")
    target = page.run("document.querySelectorAll('.result')[1].href")
    page.press("Enter")
    page.wait(f"location.href === {json.dumps(target)}")


@pytest.mark.parametrize(("query", "expected"), [
    ("SetAcSc", "AActor.SetActorScale3D"), ("sas3d", "AActor.SetActorScale3D"), ("actor scale3d", "AActor.SetActorScale3D"), ("AActor.SetActorSc", "AActor.SetActorScale3D"),

    ("AActor::SetActorSc", "AActor.SetActorScale3D"), ("getactorlocation", "AActor.K2_GetActorLocation"), ("hidden", "AActor.bHidden"), ("actor", "AActor Engine"), ("FVector.x", "FVector.X"),
    ("collisionchannel", "ECollisionChannel Engine"), ("ECC_Pawn", "ECollisionChannel.ECC_Pawn"), ("Engine", "Engine"), ("find_class", "unreal_service.find_class"),
    ("SetActorScale3D(NewScale", "AActor.SetActorScale3D"),
])
def test_queries_of_every_form(page: Browser, engine_site: Path, query: str, expected: str) -> None:
    page.open(engine_site / "index.html")
    assert expected in [found["name"] for found in _search(page, query)][:3]


def test_results_show_kind_owner_summary_and_what_matched(page: Browser, engine_site: Path) -> None:
    page.open(engine_site / "index.html")
    found = _search(page, "SetAcSc")[0]
    assert (found["kind"], found["name"], found["marked"]) == ("function", "AActor.SetActorScale3D", "SetAc Sc")
    page.wait("document.querySelector('.result .summary').textContent")
    assert page.run("document.querySelector('.result .summary').textContent") == "Set the Actor's world-space scale."


def test_kinds_narrow_the_search(page: Browser, engine_site: Path) -> None:
    page.open(engine_site / "index.html")
    assert len({found["kind"] for found in _search(page, "location")}) > 1
    for button, kinds in (("p", {"property"}), ("fx", {"function"}), ("cisedm", {"class", "struct", "enum", "interface", "delegate", "module"})):
        page.click(f"#ui-kinds button[value={button}]")
        assert {found["kind"] for found in page.run(_RESULTS)} <= kinds
        assert page.run("document.activeElement.id") == "ui-search"


def test_nothing_found_is_said(page: Browser, engine_site: Path) -> None:
    page.open(engine_site / "index.html")
    assert _search(page, "qqxyzzyqq") == []
    assert "Nothing is called" in page.run("document.getElementById('result-status').textContent")
    for odd in ("::", ".", "(", "\\", "[a-z", "<b>", "%", "a.", "#", "  "):
        page.run("document.activeElement.value = ''")
        page.type(odd)


def test_the_search_also_works_in_a_page_of_another_folder(page: Browser, engine_site: Path) -> None:
    page.open(engine_site / "CoreUObject" / "FVector.html")
    _search(page, "AActor")
    page.press("Enter")
    page.wait("location.pathname.endsWith('/Engine/AActor.html')")


def test_texts_with_markup_do_no_harm(page: Browser, maker: SchemaMaker, write: Callable[..., Path]) -> None:
    maker.add_class("AThing", comment=_NASTY, functions=(maker.function("Open", comment=_NASTY), maker.function("Open Now/später?", comment=_NASTY)))
    folder = write(maker, title="</title><script>document.title='broken'</script>")
    page.open(folder / "Game" / "AThing.html")
    assert page.run("document.title") == "AThing · </title><script>document.title='broken'</script>"
    assert page.run("document.querySelectorAll('b[onclick]').length") == 0
    found = _search(page, "opennow")
    assert [entry["name"] for entry in found] == ["AThing.Open Now/später?"]
    page.wait("document.querySelector('.result .summary').textContent.includes('</script>')")
    page.press("Enter")
    page.wait("document.querySelector(':target')")


# Pages ---------------------------------------------------------------------------------------------------------------------------


def test_links_lead_from_page_to_page(page: Browser, engine_site: Path) -> None:
    page.open(engine_site / "index.html")
    page.click("a[href='Engine/index.html']")
    page.wait("location.pathname.endsWith('/Engine/index.html') && document.readyState === 'complete'")
    page.click(".types a[href='AStaticMeshActor.html']")
    page.wait("location.pathname.endsWith('/Engine/AStaticMeshActor.html') && document.readyState === 'complete'")
    page.click(".chain a[href='AActor.html']")
    page.wait("location.pathname.endsWith('/Engine/AActor.html') && document.readyState === 'complete'")
    page.click(".crumbs a[href='../index.html']")
    page.wait("location.pathname.endsWith('/index.html') && !location.pathname.includes('Engine')")


def test_inherited_members_open_and_lead_to_the_ancestor(page: Browser, engine_site: Path) -> None:
    page.open(engine_site / "Engine" / "AStaticMeshActor.html")
    page.click("details:last-of-type summary")
    page.run("document.querySelectorAll('details').forEach(d => { d.open = true; })")
    page.click("a[href='AActor.html#SetActorScale3D']")
    page.wait("location.pathname.endsWith('/AActor.html') && document.querySelector(':target')")


def test_every_page_opens_without_a_complaint(page: Browser, engine_site: Path) -> None:
    for path in sorted(engine_site.rglob("*.html")):
        page.open(path)
        assert page.run("document.querySelector('h1').textContent.length"), path
        assert page.problems == [], path


def test_the_list_of_the_page_can_be_filtered(page: Browser, engine_site: Path) -> None:
    page.open(engine_site / "Engine" / "AActor.html")
    page.run("document.getElementById('side-filter').focus()")
    page.type("scale3d")
    shown = page.run("[...document.querySelectorAll('#ui-side a.m')].filter(a => !a.hidden).map(a => a.textContent)")
    assert "SetActorScale3D" in shown and all("scale3d" in name.lower() for name in shown)
    page.press("Enter")
    page.wait("location.hash")


def test_one_language_can_be_chosen_and_is_remembered(page: Browser, engine_site: Path) -> None:
    visible = "['py', 'cpp'].map(c => getComputedStyle(document.querySelector('.spell .' + c)).display !== 'none')"
    page.open(engine_site / "Engine" / "AActor.html")
    assert page.run(visible) == [True, True]
    page.click("#ui-languages button[value=python]")
    assert page.run(visible) == [True, False]
    page.open(engine_site / "Engine" / "APawn.html")
    assert page.run(visible) == [True, False]
    page.click("#ui-languages button[value=both]")
    assert page.run(visible) == [True, True]


def _lightness(page: Browser) -> tuple[float, float]:
    """Of ground and text, 0 to 255."""
    values = page.run("(() => { const s = getComputedStyle(document.body); return [s.backgroundColor, s.color].map(c => c.match(/[0-9.]+/g).slice(0, 3).map(Number)); })()")
    return sum(values[0]) / 3, sum(values[1]) / 3


def test_light_and_dark(page: Browser, engine_site: Path) -> None:
    page.open(engine_site / "index.html")
    ground, text = _lightness(page)
    assert ground > 230 and text < 80
    page.prefer("dark")
    ground, text = _lightness(page)
    assert ground < 50 and text > 180
    page.click("#ui-theme")
    assert _lightness(page)[0] > 230, "the choice counts more than the system"
    page.open(engine_site / "Engine" / "AActor.html")
    assert _lightness(page)[0] > 230, "it is remembered"
    page.click("#ui-theme")
    page.prefer("light")
    assert _lightness(page)[0] < 50
    page.run("localStorage.clear()")


@pytest.mark.parametrize("name", ["index.html", "entry_points.html", "Engine/index.html", "Engine/AActor.html",
                                  "Engine/UKismetMathLibrary.html", "Engine/FHitResult.html", "Engine/ECollisionChannel.html"])
def test_small_screens_need_no_sideways_scrolling(page: Browser, engine_site: Path, name: str) -> None:
    page.resize(390, 844, mobile=True)
    page.open(engine_site / name)
    assert page.run("document.documentElement.scrollWidth") <= 390
    _search(page, "location")
    box = page.run("(() => { const r = document.getElementById('ui-results').getBoundingClientRect(); return [r.left, r.right]; })()")
    assert 0 <= box[0] < box[1] <= 390


def test_the_list_of_the_page_opens_on_small_screens(page: Browser, engine_site: Path) -> None:
    page.resize(390, 844, mobile=True)
    page.open(engine_site / "Engine" / "AActor.html")
    shown = "getComputedStyle(document.getElementById('ui-side')).display !== 'none'"
    assert not page.run(shown)
    page.click("#ui-menu")
    assert page.run(shown)
    page.press("Escape")
    assert not page.run(shown)


def test_everything_can_be_reached_by_tab(page: Browser, engine_site: Path) -> None:
    page.open(engine_site / "Engine" / "ATargetPoint.html")
    reached = []
    for _ in range(12):
        page.press("Tab")
        reached.append(page.run("document.activeElement.id || document.activeElement.className || document.activeElement.textContent"))
    assert reached[0] == "skip" and "ui-search" in reached and "ui-theme" in reached and "side-filter" in reached
