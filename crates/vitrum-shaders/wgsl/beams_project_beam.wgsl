struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_13 {
member: array<f32>,
}
struct type_15 {
member: u32,
member_1: u32,
}
struct type_16 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_17 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_18 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
}
struct type_19 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_20 {
member: type_2,
member_1: type_15,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_16,
member_12: type_17,
member_13: type_18,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_19,
}
struct type_21 {
member: type_20,
}
struct type_22 {
member: f32,
member_1: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_21;
@group(0) @binding(2)
var<storage, read_write> global_2: type_13;
@group(0) @binding(1)
var<storage> global_3: type_13;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var phi_1343_: type_22;
let _e55 = global;
let _e61 = global_1.member.member;
if (_e55.x < _e61.member) {
if (_e55.y < _e61.member_1) {
let _e68 = (_e61.member * _e61.member_1);
let _e70 = ((_e55.y * _e61.member) + _e55.x);
let _e74 = global_1.member.member.member;
let _e78 = global_1.member.member.member_1;
let _e80 = bitcast<i32>((_e74 * _e78));
let _e84 = global_1.member.member_12.member_4;
let _e88 = global_1.member.member_12.member_5;
let _e90 = bitcast<i32>((_e84 * _e88));
let _e93 = bitcast<i32>(((_e55.y * _e74) + _e55.x));
local_3 = _e90;
local_4 = _e93;
local_5 = _e80;
let _e94 = local_3;
let _e95 = local_4;
let _e96 = (_e94 + _e95);
let _e98 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e100 = select(_e98, _e96, (_e96 < _e98));
let _e105 = global_3.member[bitcast<u32>(select(0i, _e100, (_e100 > 0i)))];
let _e106 = local_3;
let _e107 = local_5;
let _e109 = local_4;
let _e110 = ((_e106 + _e107) + _e109);
let _e112 = select(_e98, _e110, (_e110 < _e98));
let _e117 = global_3.member[bitcast<u32>(select(0i, _e112, (_e112 > 0i)))];
let _e118 = local_3;
let _e119 = local_5;
let _e122 = local_4;
let _e123 = ((_e118 + (2i * _e119)) + _e122);
let _e125 = select(_e98, _e123, (_e123 < _e98));
let _e130 = global_3.member[bitcast<u32>(select(0i, _e125, (_e125 > 0i)))];
let _e131 = local_3;
let _e132 = local_5;
let _e135 = local_4;
let _e136 = ((_e131 + (3i * _e132)) + _e135);
let _e138 = select(_e98, _e136, (_e136 < _e98));
let _e143 = global_3.member[bitcast<u32>(select(0i, _e138, (_e138 > 0i)))];
let _e144 = local_3;
let _e145 = local_5;
let _e148 = local_4;
let _e149 = ((_e144 + (4i * _e145)) + _e148);
let _e151 = select(_e98, _e149, (_e149 < _e98));
let _e156 = global_3.member[bitcast<u32>(select(0i, _e151, (_e151 > 0i)))];
let _e157 = local_3;
let _e158 = local_5;
let _e161 = local_4;
let _e162 = ((_e157 + (5i * _e158)) + _e161);
let _e164 = select(_e98, _e162, (_e162 < _e98));
let _e169 = global_3.member[bitcast<u32>(select(0i, _e164, (_e164 > 0i)))];
let _e170 = local_3;
let _e171 = local_5;
let _e174 = local_4;
let _e175 = ((_e170 + (6i * _e171)) + _e174);
let _e177 = select(_e98, _e175, (_e175 < _e98));
let _e182 = global_3.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e183 = local_3;
let _e184 = local_5;
let _e187 = local_4;
let _e188 = ((_e183 + (7i * _e184)) + _e187);
let _e190 = select(_e98, _e188, (_e188 < _e98));
let _e195 = global_3.member[bitcast<u32>(select(0i, _e190, (_e190 > 0i)))];
let _e196 = local_3;
let _e197 = local_5;
let _e200 = local_4;
let _e201 = ((_e196 + (8i * _e197)) + _e200);
let _e203 = select(_e98, _e201, (_e201 < _e98));
let _e208 = global_3.member[bitcast<u32>(select(0i, _e203, (_e203 > 0i)))];
let _e209 = local_3;
let _e210 = local_5;
let _e213 = local_4;
let _e214 = ((_e209 + (9i * _e210)) + _e213);
let _e216 = select(_e98, _e214, (_e214 < _e98));
let _e221 = global_3.member[bitcast<u32>(select(0i, _e216, (_e216 > 0i)))];
let _e222 = local_3;
let _e223 = local_5;
let _e226 = local_4;
let _e227 = ((_e222 + (10i * _e223)) + _e226);
let _e229 = select(_e98, _e227, (_e227 < _e98));
let _e234 = global_3.member[bitcast<u32>(select(0i, _e229, (_e229 > 0i)))];
let _e235 = local_3;
let _e236 = local_5;
let _e239 = local_4;
let _e240 = ((_e235 + (11i * _e236)) + _e239);
let _e242 = select(_e98, _e240, (_e240 < _e98));
let _e247 = global_3.member[bitcast<u32>(select(0i, _e242, (_e242 > 0i)))];
let _e248 = local_3;
let _e249 = local_5;
let _e252 = local_4;
let _e253 = ((_e248 + (12i * _e249)) + _e252);
let _e255 = select(_e98, _e253, (_e253 < _e98));
let _e260 = global_3.member[bitcast<u32>(select(0i, _e255, (_e255 > 0i)))];
let _e261 = local_3;
let _e262 = local_5;
let _e265 = local_4;
let _e266 = ((_e261 + (13i * _e262)) + _e265);
let _e268 = select(_e98, _e266, (_e266 < _e98));
let _e273 = global_3.member[bitcast<u32>(select(0i, _e268, (_e268 > 0i)))];
let _e274 = local_3;
let _e275 = local_5;
let _e278 = local_4;
let _e279 = ((_e274 + (14i * _e275)) + _e278);
let _e281 = select(_e98, _e279, (_e279 < _e98));
let _e286 = global_3.member[bitcast<u32>(select(0i, _e281, (_e281 > 0i)))];
let _e287 = local_3;
let _e288 = local_5;
let _e291 = local_4;
let _e292 = ((_e287 + (15i * _e288)) + _e291);
let _e294 = select(_e98, _e292, (_e292 < _e98));
let _e299 = global_3.member[bitcast<u32>(select(0i, _e294, (_e294 > 0i)))];
let _e300 = local_3;
let _e301 = local_5;
let _e304 = local_4;
let _e305 = ((_e300 + (16i * _e301)) + _e304);
let _e307 = select(_e98, _e305, (_e305 < _e98));
let _e312 = global_3.member[bitcast<u32>(select(0i, _e307, (_e307 > 0i)))];
let _e313 = local_3;
let _e314 = local_5;
let _e317 = local_4;
let _e318 = ((_e313 + (17i * _e314)) + _e317);
let _e320 = select(_e98, _e318, (_e318 < _e98));
let _e325 = global_3.member[bitcast<u32>(select(0i, _e320, (_e320 > 0i)))];
let _e326 = local_3;
let _e327 = local_5;
let _e330 = local_4;
let _e331 = ((_e326 + (23i * _e327)) + _e330);
let _e333 = select(_e98, _e331, (_e331 < _e98));
let _e338 = global_3.member[bitcast<u32>(select(0i, _e333, (_e333 > 0i)))];
let _e341 = global_1.member.member_6;
let _e345 = (_e105 - _e341.member);
let _e346 = (_e117 - _e341.member_1);
let _e347 = (_e130 - _e341.member_2);
let _e350 = ((_e346 * _e169) - (_e347 * _e156));
let _e353 = ((_e347 * _e143) - (_e345 * _e169));
let _e356 = ((_e345 * _e156) - (_e346 * _e143));
let _e359 = global_1.member.member_3;
let _e365 = global_1.member.member_4;
let _e371 = global_1.member.member_5;
let _e378 = global_1.member.member_2.member_3;
let _e379 = (_e378 != 0u);
let _e382 = ((_e371.member_1 * _e359.member_2) - (_e371.member_2 * _e359.member_1));
let _e385 = ((_e371.member_2 * _e359.member) - (_e371.member * _e359.member_2));
let _e388 = ((_e371.member * _e359.member_1) - (_e371.member_1 * _e359.member));
let _e400 = select((((_e359.member * _e350) + (_e359.member_1 * _e353)) + (_e359.member_2 * _e356)), -((((_e382 * _e143) + (_e385 * _e156)) + (_e388 * _e169))), _e379);
let _e403 = ((_e371.member_1 * _e365.member_2) - (_e371.member_2 * _e365.member_1));
let _e406 = ((_e371.member_2 * _e365.member) - (_e371.member * _e365.member_2));
let _e409 = ((_e371.member * _e365.member_1) - (_e371.member_1 * _e365.member));
let _e421 = select((((_e365.member * _e350) + (_e365.member_1 * _e353)) + (_e365.member_2 * _e356)), -((((_e403 * _e143) + (_e406 * _e156)) + (_e409 * _e169))), _e379);
let _e430 = global_1.member.member_1.member;
let _e432 = f32(bitcast<i32>(_e430));
let _e436 = global_1.member.member_1.member_1;
let _e438 = f32(bitcast<i32>(_e436));
let _e442 = global_1.member.member_2.member;
let _e446 = global_1.member.member_2.member_1;
let _e448 = ((2f * _e442) / _e432);
let _e449 = (_e400 * _e448);
let _e451 = ((-2f * _e446) / _e438);
let _e452 = (_e421 * _e451);
let _e454 = ((_e442 / _e432) - _e442);
let _e458 = (_e446 - (_e446 / _e438));
let _e479 = (((_e195 * _e169) - (_e208 * _e156)) + ((_e346 * _e286) - (_e347 * _e273)));
let _e480 = (((_e208 * _e143) - (_e182 * _e169)) + ((_e347 * _e260) - (_e345 * _e286)));
let _e481 = (((_e182 * _e156) - (_e195 * _e143)) + ((_e345 * _e273) - (_e346 * _e260)));
let _e493 = select((((_e359.member * _e479) + (_e359.member_1 * _e480)) + (_e359.member_2 * _e481)), -((((_e382 * _e260) + (_e385 * _e273)) + (_e388 * _e286))), _e379);
let _e505 = select((((_e365.member * _e479) + (_e365.member_1 * _e480)) + (_e365.member_2 * _e481)), -((((_e403 * _e260) + (_e406 * _e273)) + (_e409 * _e286))), _e379);
let _e511 = (_e493 * _e448);
let _e512 = (_e505 * _e451);
let _e516 = (((((_e371.member * _e479) + (_e371.member_1 * _e480)) + (_e371.member_2 * _e481)) + (_e493 * _e454)) + (_e505 * _e458));
let _e535 = (((_e234 * _e169) - (_e247 * _e156)) + ((_e346 * _e325) - (_e347 * _e312)));
let _e536 = (((_e247 * _e143) - (_e221 * _e169)) + ((_e347 * _e299) - (_e345 * _e325)));
let _e537 = (((_e221 * _e156) - (_e234 * _e143)) + ((_e345 * _e312) - (_e346 * _e299)));
let _e549 = select((((_e359.member * _e535) + (_e359.member_1 * _e536)) + (_e359.member_2 * _e537)), -((((_e382 * _e299) + (_e385 * _e312)) + (_e388 * _e325))), _e379);
let _e561 = select((((_e365.member * _e535) + (_e365.member_1 * _e536)) + (_e365.member_2 * _e537)), -((((_e403 * _e299) + (_e406 * _e312)) + (_e409 * _e325))), _e379);
let _e567 = (_e549 * _e448);
let _e568 = (_e561 * _e451);
let _e572 = (((((_e371.member * _e535) + (_e371.member_1 * _e536)) + (_e371.member_2 * _e537)) + (_e549 * _e454)) + (_e561 * _e458));
let _e579 = (bitcast<f32>((bitcast<u32>(_e449) & 2147483647u)) > bitcast<f32>((bitcast<u32>(_e452) & 2147483647u)));
let _e580 = select(_e449, _e452, _e579);
let _e581 = select(_e452, _e449, _e579);
let _e582 = select(_e511, _e512, _e579);
let _e583 = select(_e512, _e511, _e579);
let _e584 = select(_e567, _e568, _e579);
let _e585 = select(_e568, _e567, _e579);
let _e588 = bitcast<f32>((bitcast<u32>(_e581) & 2147483647u));
let _e594 = ((((_e371.member * _e345) + (_e371.member_1 * _e346)) + (_e371.member_2 * _e347)) - 1e-3f);
let _e599 = (((_e371.member * _e143) + (_e371.member_1 * _e156)) + (_e371.member_2 * _e169));
if (_e378 == 0u) {
let _e602 = (_e599 == 0f);
let _e604 = (-(_e594) / select(_e599, 1e-30f, _e602));
phi_1343_ = type_22(select(0f, select(0f, _e604, (_e604 > 0f)), (_e599 > 0f)), select(select(_e338, select(_e338, _e604, (_e604 < _e338)), (_e599 < 0f)), -1f, (_e602 && (_e594 < 0f))));
} else {
phi_1343_ = type_22(0f, _e338);
}
let _e619 = phi_1343_;
let _e628 = ((_e105 + (_e143 * _e619.member)) - _e341.member);
let _e629 = ((_e117 + (_e156 * _e619.member)) - _e341.member_1);
let _e630 = ((_e130 + (_e169 * _e619.member)) - _e341.member_2);
let _e635 = (((_e371.member * _e628) + (_e371.member_1 * _e629)) + (_e371.member_2 * _e630));
let _e639 = select((1f / select(1e-3f, _e635, (_e635 > 1e-3f))), 1f, _e379);
let _e648 = (0.5f * _e432);
let _e650 = ((((((((_e359.member * _e628) + (_e359.member_1 * _e629)) + (_e359.member_2 * _e630)) * _e639) / _e442) + 1f) * _e648) - 0.5f);
let _e659 = (0.5f * _e438);
let _e661 = (((1f - (((((_e365.member * _e628) + (_e365.member_1 * _e629)) + (_e365.member_2 * _e630)) * _e639) / _e446)) * _e659) - 0.5f);
let _e662 = -(1e6f);
let _e664 = select(_e662, _e650, (_e650 > _e662));
let _e666 = select(1e6f, _e664, (_e664 < 1e6f));
let _e668 = select(_e662, _e661, (_e661 > _e662));
let _e670 = select(1e6f, _e668, (_e668 < 1e6f));
let _e671 = select(_e666, _e670, _e579);
let _e672 = select(_e670, _e666, _e579);
let _e690 = (bitcast<f32>((bitcast<u32>(_e580) & 2147483647u)) / _e588);
let _e694 = (0.5f * 1f);
let _e697 = ((2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e582 * _e671) + ((_e583 * _e672) + _e516))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e584 * _e671) + ((_e585 * _e672) + _e572))) & 2147483647u)))) / _e588) + _e694)) * _e690);
let _e700 = (select(1e6f, _e697, (_e697 < 1e6f)) + 1f);
let _e707 = ((_e105 + (_e143 * _e619.member_1)) - _e341.member);
let _e708 = ((_e117 + (_e156 * _e619.member_1)) - _e341.member_1);
let _e709 = ((_e130 + (_e169 * _e619.member_1)) - _e341.member_2);
let _e714 = (((_e371.member * _e707) + (_e371.member_1 * _e708)) + (_e371.member_2 * _e709));
let _e718 = select((1f / select(1e-3f, _e714, (_e714 > 1e-3f))), 1f, _e379);
let _e728 = ((((((((_e359.member * _e707) + (_e359.member_1 * _e708)) + (_e359.member_2 * _e709)) * _e718) / _e442) + 1f) * _e648) - 0.5f);
let _e738 = (((1f - (((((_e365.member * _e707) + (_e365.member_1 * _e708)) + (_e365.member_2 * _e709)) * _e718) / _e446)) * _e659) - 0.5f);
let _e740 = select(_e662, _e728, (_e728 > _e662));
let _e742 = select(1e6f, _e740, (_e740 < 1e6f));
let _e744 = select(_e662, _e738, (_e738 > _e662));
let _e746 = select(1e6f, _e744, (_e744 < 1e6f));
let _e747 = select(_e742, _e746, _e579);
let _e748 = select(_e746, _e742, _e579);
let _e768 = ((2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e582 * _e747) + ((_e583 * _e748) + _e516))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e584 * _e747) + ((_e585 * _e748) + _e572))) & 2147483647u)))) / _e588) + _e694)) * _e690);
let _e771 = (select(1e6f, _e768, (_e768 < 1e6f)) + 1f);
let _e772 = (_e747 < _e671);
let _e773 = (_e671 - _e700);
let _e774 = (_e747 - _e771);
let _e777 = (_e671 + _e700);
let _e778 = (_e747 + _e771);
local = _e90;
local_1 = _e93;
local_2 = _e80;
let _e781 = local;
let _e782 = local_2;
let _e785 = local_1;
let _e786 = ((_e781 + (18i * _e782)) + _e785);
let _e788 = select(_e98, _e786, (_e786 < _e98));
let _e793 = global_3.member[bitcast<u32>(select(0i, _e788, (_e788 > 0i)))];
let _e794 = local;
let _e795 = local_2;
let _e798 = local_1;
let _e799 = ((_e794 + (19i * _e795)) + _e798);
let _e801 = select(_e98, _e799, (_e799 < _e98));
let _e806 = global_3.member[bitcast<u32>(select(0i, _e801, (_e801 > 0i)))];
let _e808 = local;
let _e809 = local_2;
let _e812 = local_1;
let _e813 = ((_e808 + (20i * _e809)) + _e812);
let _e815 = select(_e98, _e813, (_e813 < _e98));
let _e820 = global_3.member[bitcast<u32>(select(0i, _e815, (_e815 > 0i)))];
let _e826 = (((((_e793 + _e806) + _e820) > 0f) && (_e588 > 0f)) && (_e619.member_1 > _e619.member));
global_2.member[_e70] = select(0f, 1f, _e579);
global_2.member[(_e68 + _e70)] = _e580;
global_2.member[((2u * _e68) + _e70)] = _e581;
global_2.member[((3u * _e68) + _e70)] = (((((_e371.member * _e350) + (_e371.member_1 * _e353)) + (_e371.member_2 * _e356)) + (_e400 * _e454)) + (_e421 * _e458));
global_2.member[((4u * _e68) + _e70)] = _e582;
global_2.member[((5u * _e68) + _e70)] = _e583;
global_2.member[((6u * _e68) + _e70)] = _e516;
global_2.member[((7u * _e68) + _e70)] = _e584;
global_2.member[((8u * _e68) + _e70)] = _e585;
global_2.member[((9u * _e68) + _e70)] = _e572;
global_2.member[((10u * _e68) + _e70)] = select(0f, select(_e774, _e773, (_e773 < _e774)), _e826);
global_2.member[((11u * _e68) + _e70)] = select(-1f, select(_e778, _e777, (_e777 > _e778)), _e826);
global_2.member[((12u * _e68) + _e70)] = select(_e777, _e778, _e772);
global_2.member[((13u * _e68) + _e70)] = select(_e774, _e773, _e772);
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
