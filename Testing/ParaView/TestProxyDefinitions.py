# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the XML of the plugin says agrees with the classes: names, settings, defaults and texts."""

import inspect
import re

import surfacedenoising
from paraview import make_name_valid, servermanager
from vtkmodules.vtkCommonExecutionModel import vtkPolyDataAlgorithm

problems = []

# Classes whose proxies are not in the menu, but tell what others share.
BASES = {"vtkMeshDenoisingFilter", "vtkFaceNormalFilter", "vtkNormalFittingFilter",
         "vtkOneStageFilter", "vtkPointDenoisingFilter", "vtkPointNeighborhoodFilter",
         "vtkPointFittingFilter"}

# Numbers that are the same for all objects.
STATIC = {"GetNumberOfNorms", "GetNumberOfPresets"}


def expect(condition, *message):
    if not condition:
        problems.append(": ".join(str(part) for part in message))


def concrete_filters():
    """Name of the proxy and an object for every filter of the package."""
    for name, cls in inspect.getmembers(surfacedenoising, inspect.isclass):
        if issubclass(cls, vtkPolyDataAlgorithm) and not name.endswith("Reader"):
            try:
                yield name[len("vtk"):], cls()
            except TypeError:
                pass  # abstract


def bases(cls):
    """The abstract classes of the package that a class is made of."""
    for base in cls.__mro__[1:]:
        if getattr(surfacedenoising, base.__name__, None) is base:
            yield base


def properties(proxy):
    iterator = proxy.NewPropertyIterator()
    iterator.UnRegister(None)
    iterator.Begin()
    while not iterator.IsAtEnd():
        yield iterator.GetKey(), iterator.GetProperty()
        iterator.Next()


def settings(vtk_object):
    """Names X of all pairs SetX, GetX that the classes of the project add."""
    added = set(dir(vtk_object)) - set(dir(vtkPolyDataAlgorithm))
    return {name[3:] for name in added if name.startswith("Set") and "G" + name[1:] in added}


def figures(vtk_object):
    """Names X of the GetX that tell a number or a text of the last execution."""
    for name in set(dir(vtk_object)) - set(dir(vtkPolyDataAlgorithm)):
        known = name[3:] in settings(vtk_object) or name.endswith(("MinValue", "MaxValue"))
        if not name.startswith("Get") or known or name in STATIC:
            continue
        try:
            value = getattr(vtk_object, name)()
        except TypeError:
            continue  # asks for something in particular
        if isinstance(value, (int, float, str)):
            yield name[3:]


def enumerators(cls):
    """Of the class and its bases, without a name that hides another: it would be wrong in one."""
    found = {}
    for part in cls.__mro__:
        for name, value in vars(part).items():
            if isinstance(value, int):
                expect(found.setdefault(name, value) == value, cls.__name__, name, "hides another")
    return found


def normalized(text):
    return text.replace(" ", "").replace("_", "").lower()


def check_proxy(name, proxy, vtk_object):
    expect(proxy.GetVTKClassName() == vtk_object.GetClassName(), name, "is of another class")
    expect(make_name_valid(proxy.GetXMLLabel()) == name, name, "label", proxy.GetXMLLabel())
    texts = proxy.GetDocumentation()
    expect(0 < len(texts.GetShortHelp() or "") <= 80, name, "short help has 1 to 80 letters")
    expect(texts.GetLongHelp(), name, "no long help")
    expect(len(texts.GetDescription() or "") > 200, name, "the description says little")
    menu = proxy.GetHints().FindNestedElementByName("ShowInMenu")
    expect(menu.GetAttribute("category") == "Surface Denoising", name, "menu")
    expect(proxy.GetProcessSupport() == proxy.SINGLE_PROCESS, name, "has no parallel version")


def check_panel(name, proxy):
    """All that the panel shows is in a group, and what hides it is there."""
    groups = [proxy.GetPropertyGroup(i) for i in range(proxy.GetNumberOfPropertyGroups())]
    members = {group.GetProperty(i).GetXMLName()
               for group in groups for i in range(group.GetNumberOfProperties())}
    for key, prop in properties(proxy):
        if not prop.IsA("vtkSMInputProperty") and prop.GetPanelVisibility() != "never":
            expect(key in members, name, key, "is in no group")
    for part in groups + [prop for _, prop in properties(proxy)]:
        hints = part.GetHints()
        decorator = hints and hints.FindNestedElementByName("PropertyWidgetDecorator")
        if decorator:
            other = decorator.GetAttribute("property")
            expect(proxy.GetProperty(other), name, "a decorator asks for", other)


def check_enumeration(where, name, domain, vtk_object):
    entries = {domain.GetEntryText(i): domain.GetEntryValue(i)
               for i in range(domain.GetNumberOfEntries())}
    if name.endswith("Norm"):
        names = {vtk_object.GetNormName(i): i for i in range(vtk_object.GetNumberOfNorms())}
        expect(entries == names, where, "the dropdown has", entries, "the class", names)
        return
    constants = {normalized(key): value for key, value in enumerators(type(vtk_object)).items()}
    for text, value in entries.items():
        # Where two settings have a choice of the same name, the setting is part of the enumerator.
        kind = re.sub(".*(?=[A-Z])", "", name)
        found = constants.get(normalized(text + kind), constants.get(normalized(text)))
        expect(found == value, where, text, "is no enumerator of value", value)
    # The setters clamp: what is left of a huge value is the last enumerator.
    default = getattr(vtk_object, "Get" + name)()
    getattr(vtk_object, "Set" + name)(10 ** 6)
    last = getattr(vtk_object, "Get" + name)()
    getattr(vtk_object, "Set" + name)(default)
    expect(sorted(entries.values()) == list(range(last + 1)), where, "the dropdown has", entries)


def check_property(where, name, prop, vtk_object):
    expect(make_name_valid(prop.GetXMLLabel()) == name, where, "label", prop.GetXMLLabel())
    texts = prop.GetDocumentation()
    expect(texts and (texts.GetDescription() or "").strip(), where, "no documentation")
    command = prop.GetCommand()
    expect(hasattr(vtk_object, command), where, "no method", command)
    if prop.GetInformationOnly():
        expect(command == "Get" + name, where, "command", command)
        return
    if command in ("SetInputConnection", "SetInputArrayToProcess"):
        return
    expect(command == "Set" + name, where, "command", command)
    value = getattr(vtk_object, "Get" + name)()
    default = prop.GetElement(0)  # a prototype has its default values
    expect(default == value, where, "default", default, "of the class", value)
    domain = prop.FindDomain("vtkSMEnumerationDomain")
    if domain:
        check_enumeration(where, name, domain, vtk_object)


def check_base(cls, proxy):
    """The proxy of an abstract class has the settings of this class and of its bases."""
    name = proxy.GetXMLName()
    expect(proxy.GetVTKClassName() == cls.__name__, name, "is of another class")
    expect((proxy.GetDocumentation().GetDescription() or "").strip(), name, "no documentation")
    found = dict(properties(proxy))
    missing = settings(cls) - set(found)
    expect(not missing, name, "settings that the XML lacks", sorted(missing))
    for key, prop in found.items():
        expect(hasattr(cls, prop.GetCommand()), name, key, "no method", prop.GetCommand())
    check_panel(name, proxy)


servermanager.Connect()
manager = servermanager.ProxyManager()
checked, checked_bases = 0, set()
for filter_name, filter_object in concrete_filters():
    prototype = manager.GetPrototypeProxy("filters", filter_name)
    if not prototype:
        expect(False, filter_name, "the plugin has no such proxy")
        continue
    check_proxy(filter_name, prototype, filter_object)
    check_panel(filter_name, prototype)
    found = dict(properties(prototype))
    for property_name, sm_property in found.items():
        check_property(filter_name + "." + property_name, property_name, sm_property, filter_object)
    missing = settings(filter_object) - set(found)
    expect(not missing, filter_name, "settings that the XML lacks", sorted(missing))
    unsaid = set(figures(filter_object)) - set(found)
    expect(not unsaid, filter_name, "figures that the XML lacks", sorted(unsaid))
    checked += 1
    for base_class in bases(type(filter_object)):
        base_proxy = manager.GetPrototypeProxy(
            "internal_filters", base_class.__name__[len("vtk"):] + "Base")
        if base_proxy:
            check_base(base_class, base_proxy)
            checked_bases.add(base_class.__name__)

assert checked >= 25, "only {} filters were found".format(checked)
expect(checked_bases >= BASES, "no proxy of", sorted(BASES - checked_bases))
assert not problems, "\n" + "\n".join(problems)
