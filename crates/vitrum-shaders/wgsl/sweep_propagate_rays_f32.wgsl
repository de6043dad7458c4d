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
struct type_11 {
member: array<f32>,
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_18 {
member: u32,
member_1: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_21 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_18,
member_4: u32,
member_5: type_19,
member_6: type_20,
member_7: type_20,
member_8: type_21,
member_9: type_22,
member_10: f32,
member_11: type_19,
member_12: type_4,
member_13: type_9,
member_14: type_23,
member_15: type_23,
member_16: type_23,
member_17: type_23,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_25 {
member: vec3<f32>,
member_1: vec3<f32>,
}
struct type_28 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_29 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_30 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_31 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
}
struct type_33 {
member: array<type_24>,
}
var<private> global: vec3<u32>;
@group(0) @binding(1)
var<storage> global_1: type_16;
@group(0) @binding(3)
var<storage> global_2: type_16;
@group(0) @binding(4)
var<storage> global_3: type_16;
@group(0) @binding(6)
var<storage, read_write> global_4: type_11;
@group(0) @binding(0)
var<storage> global_5: type_33;
@group(0) @binding(5)
var<storage> global_6: type_11;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var local_6: type_28;
var local_7: vec3<f32>;
var phi_581_: u32;
var phi_584_: bool;
var phi_586_: array<f32, 18>;
var phi_3483_: type_29;
var phi_4129_: type_30;
var phi_4712_: f32;
var phi_5101_: type_5;
var phi_6659_: type_31;
var phi_7412_: vec3<f32>;
var phi_7642_: type_25;
var phi_7960_: vec3<f32>;
var phi_8265_: vec3<f32>;
var phi_8266_: bool;
var phi_8331_: array<f32, 18>;
var phi_582_: u32;
var phi_585_: bool;
var phi_587_: array<f32, 18>;
var phi_8414_: bool;
var local_8: bool;
var local_9: array<f32, 18>;
var local_10: array<f32, 18>;
var local_11: array<f32, 18>;
var local_12: array<f32, 18>;
var local_13: array<f32, 18>;
var local_14: array<f32, 18>;
var local_15: array<f32, 18>;
var local_16: array<f32, 18>;
var local_17: array<f32, 18>;
var local_18: array<f32, 18>;
var local_19: array<f32, 18>;
var local_20: array<f32, 18>;
var local_21: array<f32, 18>;
var local_22: array<f32, 18>;
var local_23: array<f32, 18>;
var local_24: array<f32, 18>;
var local_25: array<f32, 18>;
var local_26: array<f32, 18>;
switch bitcast<i32>(0u) {
default: {
let _e113 = global;
let _e115 = arrayLength((&global_5.member));
let _e118 = arrayLength((&global_1.member));
let _e122 = arrayLength((&global_3.member));
if (0u < _e115) {
} else {
break;
}
let _e132 = global_5.member[0u].member_2;
let _e136 = global_5.member[0u].member;
let _e144 = (_e113.x + _e132.member);
let _e146 = (_e113.y + _e132.member_1);
if (_e144 < _e132.member_2) {
if (_e146 < _e132.member_3) {
let _e149 = (_e136.member * _e136.member_1);
let _e151 = ((_e146 * _e136.member) + _e144);
let _e152 = bitcast<i32>(_e151);
let _e154 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e156 = select(_e154, _e152, (_e152 < _e154));
let _e162 = global_4.member[bitcast<u32>(select(0i, _e156, (_e156 > 0i)))];
let _e163 = (_e149 + _e151);
let _e164 = bitcast<i32>(_e163);
let _e166 = select(_e154, _e164, (_e164 < _e154));
let _e172 = global_4.member[bitcast<u32>(select(0i, _e166, (_e166 > 0i)))];
let _e174 = ((2u * _e149) + _e151);
let _e175 = bitcast<i32>(_e174);
let _e177 = select(_e154, _e175, (_e175 < _e154));
let _e183 = global_4.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e185 = ((3u * _e149) + _e151);
let _e186 = bitcast<i32>(_e185);
let _e188 = select(_e154, _e186, (_e186 < _e154));
let _e194 = global_4.member[bitcast<u32>(select(0i, _e188, (_e188 > 0i)))];
let _e196 = ((4u * _e149) + _e151);
let _e197 = bitcast<i32>(_e196);
let _e199 = select(_e154, _e197, (_e197 < _e154));
let _e205 = global_4.member[bitcast<u32>(select(0i, _e199, (_e199 > 0i)))];
let _e207 = ((5u * _e149) + _e151);
let _e208 = bitcast<i32>(_e207);
let _e210 = select(_e154, _e208, (_e208 < _e154));
let _e216 = global_4.member[bitcast<u32>(select(0i, _e210, (_e210 > 0i)))];
let _e218 = ((6u * _e149) + _e151);
let _e219 = bitcast<i32>(_e218);
let _e221 = select(_e154, _e219, (_e219 < _e154));
let _e227 = global_4.member[bitcast<u32>(select(0i, _e221, (_e221 > 0i)))];
let _e229 = ((7u * _e149) + _e151);
let _e230 = bitcast<i32>(_e229);
let _e232 = select(_e154, _e230, (_e230 < _e154));
let _e238 = global_4.member[bitcast<u32>(select(0i, _e232, (_e232 > 0i)))];
let _e240 = ((8u * _e149) + _e151);
let _e241 = bitcast<i32>(_e240);
let _e243 = select(_e154, _e241, (_e241 < _e154));
let _e249 = global_4.member[bitcast<u32>(select(0i, _e243, (_e243 > 0i)))];
let _e251 = ((9u * _e149) + _e151);
let _e252 = bitcast<i32>(_e251);
let _e254 = select(_e154, _e252, (_e252 < _e154));
let _e260 = global_4.member[bitcast<u32>(select(0i, _e254, (_e254 > 0i)))];
let _e262 = ((10u * _e149) + _e151);
let _e263 = bitcast<i32>(_e262);
let _e265 = select(_e154, _e263, (_e263 < _e154));
let _e271 = global_4.member[bitcast<u32>(select(0i, _e265, (_e265 > 0i)))];
let _e273 = ((11u * _e149) + _e151);
let _e274 = bitcast<i32>(_e273);
let _e276 = select(_e154, _e274, (_e274 < _e154));
let _e282 = global_4.member[bitcast<u32>(select(0i, _e276, (_e276 > 0i)))];
let _e284 = ((12u * _e149) + _e151);
let _e285 = bitcast<i32>(_e284);
let _e287 = select(_e154, _e285, (_e285 < _e154));
let _e293 = global_4.member[bitcast<u32>(select(0i, _e287, (_e287 > 0i)))];
let _e295 = ((13u * _e149) + _e151);
let _e296 = bitcast<i32>(_e295);
let _e298 = select(_e154, _e296, (_e296 < _e154));
let _e304 = global_4.member[bitcast<u32>(select(0i, _e298, (_e298 > 0i)))];
let _e306 = ((14u * _e149) + _e151);
let _e307 = bitcast<i32>(_e306);
let _e309 = select(_e154, _e307, (_e307 < _e154));
let _e315 = global_4.member[bitcast<u32>(select(0i, _e309, (_e309 > 0i)))];
let _e317 = ((15u * _e149) + _e151);
let _e318 = bitcast<i32>(_e317);
let _e320 = select(_e154, _e318, (_e318 < _e154));
let _e326 = global_4.member[bitcast<u32>(select(0i, _e320, (_e320 > 0i)))];
let _e328 = ((16u * _e149) + _e151);
let _e329 = bitcast<i32>(_e328);
let _e331 = select(_e154, _e329, (_e329 < _e154));
let _e337 = global_4.member[bitcast<u32>(select(0i, _e331, (_e331 > 0i)))];
let _e339 = ((17u * _e149) + _e151);
let _e340 = bitcast<i32>(_e339);
let _e342 = select(_e154, _e340, (_e340 < _e154));
let _e348 = global_4.member[bitcast<u32>(select(0i, _e342, (_e342 > 0i)))];
phi_581_ = 0u;
phi_584_ = false;
phi_586_ = array<f32, 18>(_e162, _e172, _e183, _e194, _e205, _e216, _e227, _e238, _e249, _e260, _e271, _e282, _e293, _e304, _e315, _e326, _e337, _e348);
loop {
let _e351 = phi_581_;
let _e353 = phi_584_;
let _e355 = phi_586_;
local_8 = _e353;
local_9 = _e355;
local_10 = _e355;
local_11 = _e355;
local_12 = _e355;
local_13 = _e355;
local_14 = _e355;
local_15 = _e355;
local_16 = _e355;
local_17 = _e355;
local_18 = _e355;
local_19 = _e355;
local_20 = _e355;
local_21 = _e355;
local_22 = _e355;
local_23 = _e355;
local_24 = _e355;
local_25 = _e355;
local_26 = _e355;
let _e356 = (_e351 < _e115);
if _e356 {
if _e356 {
} else {
phi_8414_ = true;
break;
}
let _e369 = global_5.member[_e351].member_5.member_2;
let _e370 = (_e369 / _e355[5]);
let _e375 = global_5.member[_e351].member_5.member;
let _e377 = ((_e375 - _e355[2]) / _e355[5]);
let _e379 = (_e355[0] + (_e355[3] * _e377));
let _e381 = (_e355[1] + (_e355[4] * _e377));
let _e383 = (_e379 + (_e355[3] * _e370));
let _e385 = (_e381 + (_e355[4] * _e370));
let _e390 = global_5.member[_e351].member_5.member_1;
let _e396 = global_5.member[_e351].member_13.member.member;
let _e407 = ((((_e396.member.member * _e379) + (_e396.member.member_1 * _e381)) + (_e396.member.member_2 * _e375)) + _e396.member_1);
let _e413 = ((((_e396.member.member * _e383) + (_e396.member.member_1 * _e385)) + (_e396.member.member_2 * _e390)) + _e396.member_1);
let _e416 = ((_e407 > 0f) && (_e413 <= 0f));
let _e422 = global_5.member[_e351].member_13.member_1.member;
let _e433 = ((((_e422.member.member * _e379) + (_e422.member.member_1 * _e381)) + (_e422.member.member_2 * _e375)) + _e422.member_1);
let _e439 = ((((_e422.member.member * _e383) + (_e422.member.member_1 * _e385)) + (_e422.member.member_2 * _e390)) + _e422.member_1);
let _e442 = ((_e433 > 0f) && (_e439 <= 0f));
let _e443 = (_e416 || _e442);
let _e448 = global_5.member[_e351].member_6.member;
let _e459 = ((((_e448.member.member * _e379) + (_e448.member.member_1 * _e381)) + (_e448.member.member_2 * _e375)) + _e448.member_1);
let _e464 = global_5.member[_e351].member_6.member_1;
let _e475 = ((((_e464.member.member * _e379) + (_e464.member.member_1 * _e381)) + (_e464.member.member_2 * _e375)) + _e464.member_1);
let _e480 = global_5.member[_e351].member_6.member_2;
let _e491 = ((((_e480.member.member * _e379) + (_e480.member.member_1 * _e381)) + (_e480.member.member_2 * _e375)) + _e480.member_1);
let _e497 = ((((_e448.member.member * _e383) + (_e448.member.member_1 * _e385)) + (_e448.member.member_2 * _e390)) + _e448.member_1);
let _e503 = ((((_e464.member.member * _e383) + (_e464.member.member_1 * _e385)) + (_e464.member.member_2 * _e390)) + _e464.member_1);
let _e509 = ((((_e480.member.member * _e383) + (_e480.member.member_1 * _e385)) + (_e480.member.member_2 * _e390)) + _e480.member_1);
let _e514 = global_5.member[_e351].member_6.member_4;
let _e520 = global_5.member[_e351].member_6.member_3.member;
let _e521 = (_e520 - 0.5f);
let _e523 = select(-0.5f, _e497, (_e497 > -0.5f));
let _e525 = select(_e521, _e523, (_e523 < _e521));
let _e531 = global_5.member[_e351].member_6.member_3.member_1;
let _e532 = (_e531 - 0.5f);
let _e534 = select(-0.5f, _e503, (_e503 > -0.5f));
let _e536 = select(_e532, _e534, (_e534 < _e532));
let _e542 = global_5.member[_e351].member_6.member_3.member_2;
let _e543 = (_e542 - 0.5f);
let _e545 = select(-0.5f, _e509, (_e509 > -0.5f));
let _e547 = select(_e543, _e545, (_e545 < _e543));
let _e548 = (_e497 - _e459);
let _e549 = (_e503 - _e475);
let _e550 = (_e509 - _e491);
let _e553 = bitcast<f32>((bitcast<u32>(_e548) & 2147483647u));
let _e556 = bitcast<f32>((bitcast<u32>(_e549) & 2147483647u));
let _e558 = select(_e556, _e553, (_e553 > _e556));
let _e561 = bitcast<f32>((bitcast<u32>(_e550) & 2147483647u));
let _e570 = bitcast<f32>((bitcast<u32>((_e497 - _e525)) & 2147483647u));
let _e573 = bitcast<f32>((bitcast<u32>((_e503 - _e536)) & 2147483647u));
let _e575 = select(_e573, _e570, (_e570 > _e573));
let _e578 = bitcast<f32>((bitcast<u32>((_e509 - _e547)) & 2147483647u));
let _e582 = (_e525 + 0.5f);
let _e583 = (_e520 - 1f);
let _e585 = select(0f, _e582, (_e582 > 0f));
let _e587 = select(_e583, _e585, (_e585 < _e583));
let _e594 = select(0i, select(select(i32(_e587), i32(-2147483648), (_e587 < -2147483600f)), 2147483647i, (_e587 > 2147483500f)), (_e587 == _e587));
let _e603 = global_5.member[_e351].member_6.member_12;
let _e604 = (_e603 & 31u);
let _e607 = (_e536 + 0.5f);
let _e608 = (_e531 - 1f);
let _e610 = select(0f, _e607, (_e607 > 0f));
let _e612 = select(_e608, _e610, (_e610 < _e608));
let _e619 = select(0i, select(select(i32(_e612), i32(-2147483648), (_e612 < -2147483600f)), 2147483647i, (_e612 > 2147483500f)), (_e612 == _e612));
let _e626 = (_e547 + 0.5f);
let _e627 = (_e542 - 1f);
let _e629 = select(0f, _e626, (_e626 > 0f));
let _e631 = select(_e627, _e629, (_e629 < _e627));
let _e638 = select(0i, select(select(i32(_e631), i32(-2147483648), (_e631 < -2147483600f)), 2147483647i, (_e631 > 2147483500f)), (_e631 == _e631));
let _e650 = global_5.member[_e351].member_6.member_9.member;
let _e657 = global_5.member[_e351].member_6.member_9.member_1;
let _e663 = global_5.member[_e351].member_6.member_10;
let _e669 = ((bitcast<i32>(_e663) + ((_e594 - select(0i, 1i, (_e587 < f32(_e594)))) >> bitcast<u32>(_e604))) + (bitcast<i32>(_e650) * (((_e619 - select(0i, 1i, (_e612 < f32(_e619)))) >> bitcast<u32>(_e604)) + (bitcast<i32>(_e657) * ((_e638 - select(0i, 1i, (_e631 < f32(_e638)))) >> bitcast<u32>(_e604))))));
let _e671 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e673 = select(_e671, _e669, (_e669 < _e671));
let _e679 = global_2.member[bitcast<u32>(select(0i, _e673, (_e673 > 0i)))];
let _e686 = global_5.member[_e351].member_1;
let _e718 = (_e355[17] != _e375);
let _e724 = (select(0u, select(select(select(select(7u, 3u, (((((((_e459 >= 0f) && (_e459 <= _e583)) && (_e475 >= 0f)) && (_e475 <= _e608)) && (_e491 >= 0f)) && (_e491 <= _e627)) && ((((((_e497 >= 0f) && (_e497 <= _e583)) && (_e503 >= 0f)) && (_e503 <= _e608)) && (_e509 >= 0f)) && (_e509 <= _e627)))), 15u, _e718), 1u, (((_e686 & 64u) != 0u) || ((((select(_e561, _e558, (_e558 > _e561)) <= _e514) && ((select(_e578, _e575, (_e575 > _e578)) > _e514) || (_e679 != 0u))) && true) && ((_e686 & 32u) != 0u)))), 31u, _e443), (_e355[7] == 0f)) > 1u);
if _e724 {
let _e728 = global_5.member[_e351].member;
let _e741 = (_e407 - _e413);
let _e744 = (_e407 / select(1e-20f, _e741, (_e741 > 1e-20f)));
let _e745 = (_e433 - _e439);
let _e748 = (_e433 / select(1e-20f, _e745, (_e745 > 1e-20f)));
let _e752 = (_e442 && (!(_e416) || (_e748 < _e744)));
let _e759 = global_5.member[_e351].member_13.member_1.member.member;
let _e765 = global_5.member[_e351].member_13.member_1.member_1;
let _e772 = global_5.member[_e351].member_13.member.member.member;
let _e778 = global_5.member[_e351].member_13.member.member_1;
let _e797 = select(_e744, _e748, _e752);
let _e799 = (_e728.member_2 == 2u);
let _e802 = (((_e728.member_2 == 1u) || _e799) || (_e728.member_2 == 5u));
if _e802 {
let _e804 = select(-1f, _e525, (_e525 > -1f));
let _e806 = select(_e520, _e804, (_e804 < _e520));
let _e813 = select(0i, select(select(i32(_e806), i32(-2147483648), (_e806 < -2147483600f)), 2147483647i, (_e806 > 2147483500f)), (_e806 == _e806));
let _e817 = (_e813 - select(0i, 1i, (_e806 < f32(_e813))));
let _e819 = select(-1f, _e536, (_e536 > -1f));
let _e821 = select(_e531, _e819, (_e819 < _e531));
let _e828 = select(0i, select(select(i32(_e821), i32(-2147483648), (_e821 < -2147483600f)), 2147483647i, (_e821 > 2147483500f)), (_e821 == _e821));
let _e832 = (_e828 - select(0i, 1i, (_e821 < f32(_e828))));
let _e834 = select(-1f, _e547, (_e547 > -1f));
let _e836 = select(_e542, _e834, (_e834 < _e542));
let _e843 = select(0i, select(select(i32(_e836), i32(-2147483648), (_e836 < -2147483600f)), 2147483647i, (_e836 > 2147483500f)), (_e836 == _e836));
let _e847 = (_e843 - select(0i, 1i, (_e836 < f32(_e843))));
let _e852 = global_5.member[_e351].member_6.member_7;
let _e857 = global_5.member[_e351].member_6.member_8;
let _e865 = (select(0i, select(select(i32(_e531), i32(-2147483648), (_e531 < -2147483600f)), 2147483647i, (_e531 > 2147483500f)), (_e531 == _e531)) - 1i);
let _e866 = (_e832 - 1i);
let _e871 = (_e832 + 1i);
let _e874 = (_e832 + 2i);
let _e884 = (select(0i, select(select(i32(_e542), i32(-2147483648), (_e542 < -2147483600f)), 2147483647i, (_e542 > 2147483500f)), (_e542 == _e542)) - 1i);
let _e885 = (_e847 - 1i);
let _e890 = (_e847 + 1i);
let _e893 = (_e847 + 2i);
let _e903 = (select(0i, select(select(i32(_e520), i32(-2147483648), (_e520 < -2147483600f)), 2147483647i, (_e520 > 2147483500f)), (_e520 == _e520)) - 1i);
let _e904 = (_e817 - 1i);
let _e909 = (_e817 + 1i);
let _e912 = (_e817 + 2i);
let _e915 = (select(0i, _e866, (_e866 > 0i)) * _e852);
let _e916 = (select(0i, _e832, (_e832 > 0i)) * _e852);
let _e917 = (select(_e865, _e871, (_e871 < _e865)) * _e852);
let _e918 = (select(_e865, _e874, (_e874 < _e865)) * _e852);
let _e919 = (select(0i, _e885, (_e885 > 0i)) * _e857);
let _e920 = (select(0i, _e847, (_e847 > 0i)) * _e857);
let _e921 = (select(_e884, _e890, (_e890 < _e884)) * _e857);
let _e922 = (select(_e884, _e893, (_e893 < _e884)) * _e857);
local_6 = type_28(array<i32, 4>(select(0i, _e904, (_e904 > 0i)), select(0i, _e817, (_e817 > 0i)), select(_e903, _e909, (_e909 < _e903)), select(_e903, _e912, (_e912 < _e903))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_7 = vec3<f32>((_e525 - f32(_e817)), (_e536 - f32(_e832)), (_e547 - f32(_e847)));
let _e933 = (_e920 + _e916);
let _e936 = local_6.member[0u];
let _e937 = (_e933 + _e936);
let _e939 = (bitcast<i32>(_e118) - 1i);
let _e941 = select(_e939, _e937, (_e937 < _e939));
let _e946 = global_1.member[bitcast<u32>(select(0i, _e941, (_e941 > 0i)))];
let _e947 = bitcast<f32>(_e946);
let _e950 = local_6.member[1u];
let _e951 = (_e933 + _e950);
let _e953 = select(_e939, _e951, (_e951 < _e939));
let _e958 = global_1.member[bitcast<u32>(select(0i, _e953, (_e953 > 0i)))];
let _e959 = bitcast<f32>(_e958);
let _e962 = local_6.member[2u];
let _e963 = (_e933 + _e962);
let _e965 = select(_e939, _e963, (_e963 < _e939));
let _e970 = global_1.member[bitcast<u32>(select(0i, _e965, (_e965 > 0i)))];
let _e971 = bitcast<f32>(_e970);
let _e974 = local_6.member[3u];
let _e975 = (_e933 + _e974);
let _e977 = select(_e939, _e975, (_e975 < _e939));
let _e982 = global_1.member[bitcast<u32>(select(0i, _e977, (_e977 > 0i)))];
let _e984 = local_7[0u];
let _e987 = (_e947 + ((_e959 - _e947) * _e984));
let _e988 = local_7[0u];
let _e991 = (_e959 + ((_e971 - _e959) * _e988));
let _e992 = local_7[0u];
let _e995 = (_e971 + ((bitcast<f32>(_e982) - _e971) * _e992));
let _e996 = (_e920 + _e917);
let _e997 = local_6.member[0u];
let _e998 = (_e996 + _e997);
let _e1000 = select(_e939, _e998, (_e998 < _e939));
let _e1005 = global_1.member[bitcast<u32>(select(0i, _e1000, (_e1000 > 0i)))];
let _e1006 = bitcast<f32>(_e1005);
let _e1007 = local_6.member[1u];
let _e1008 = (_e996 + _e1007);
let _e1010 = select(_e939, _e1008, (_e1008 < _e939));
let _e1015 = global_1.member[bitcast<u32>(select(0i, _e1010, (_e1010 > 0i)))];
let _e1016 = bitcast<f32>(_e1015);
let _e1017 = local_6.member[2u];
let _e1018 = (_e996 + _e1017);
let _e1020 = select(_e939, _e1018, (_e1018 < _e939));
let _e1025 = global_1.member[bitcast<u32>(select(0i, _e1020, (_e1020 > 0i)))];
let _e1026 = bitcast<f32>(_e1025);
let _e1027 = local_6.member[3u];
let _e1028 = (_e996 + _e1027);
let _e1030 = select(_e939, _e1028, (_e1028 < _e939));
let _e1035 = global_1.member[bitcast<u32>(select(0i, _e1030, (_e1030 > 0i)))];
let _e1037 = local_7[0u];
let _e1041 = local_7[0u];
let _e1044 = (_e1016 + ((_e1026 - _e1016) * _e1041));
let _e1045 = local_7[0u];
let _e1049 = (_e921 + _e916);
let _e1050 = local_6.member[0u];
let _e1051 = (_e1049 + _e1050);
let _e1053 = select(_e939, _e1051, (_e1051 < _e939));
let _e1058 = global_1.member[bitcast<u32>(select(0i, _e1053, (_e1053 > 0i)))];
let _e1059 = bitcast<f32>(_e1058);
let _e1060 = local_6.member[1u];
let _e1061 = (_e1049 + _e1060);
let _e1063 = select(_e939, _e1061, (_e1061 < _e939));
let _e1068 = global_1.member[bitcast<u32>(select(0i, _e1063, (_e1063 > 0i)))];
let _e1069 = bitcast<f32>(_e1068);
let _e1070 = local_6.member[2u];
let _e1071 = (_e1049 + _e1070);
let _e1073 = select(_e939, _e1071, (_e1071 < _e939));
let _e1078 = global_1.member[bitcast<u32>(select(0i, _e1073, (_e1073 > 0i)))];
let _e1079 = bitcast<f32>(_e1078);
let _e1080 = local_6.member[3u];
let _e1081 = (_e1049 + _e1080);
let _e1083 = select(_e939, _e1081, (_e1081 < _e939));
let _e1088 = global_1.member[bitcast<u32>(select(0i, _e1083, (_e1083 > 0i)))];
let _e1090 = local_7[0u];
let _e1093 = (_e1059 + ((_e1069 - _e1059) * _e1090));
let _e1094 = local_7[0u];
let _e1097 = (_e1069 + ((_e1079 - _e1069) * _e1094));
let _e1098 = local_7[0u];
let _e1101 = (_e1079 + ((bitcast<f32>(_e1088) - _e1079) * _e1098));
let _e1102 = (_e921 + _e917);
let _e1103 = local_6.member[0u];
let _e1104 = (_e1102 + _e1103);
let _e1106 = select(_e939, _e1104, (_e1104 < _e939));
let _e1111 = global_1.member[bitcast<u32>(select(0i, _e1106, (_e1106 > 0i)))];
let _e1112 = bitcast<f32>(_e1111);
let _e1113 = local_6.member[1u];
let _e1114 = (_e1102 + _e1113);
let _e1116 = select(_e939, _e1114, (_e1114 < _e939));
let _e1121 = global_1.member[bitcast<u32>(select(0i, _e1116, (_e1116 > 0i)))];
let _e1122 = bitcast<f32>(_e1121);
let _e1123 = local_6.member[2u];
let _e1124 = (_e1102 + _e1123);
let _e1126 = select(_e939, _e1124, (_e1124 < _e939));
let _e1131 = global_1.member[bitcast<u32>(select(0i, _e1126, (_e1126 > 0i)))];
let _e1132 = bitcast<f32>(_e1131);
let _e1133 = local_6.member[3u];
let _e1134 = (_e1102 + _e1133);
let _e1136 = select(_e939, _e1134, (_e1134 < _e939));
let _e1141 = global_1.member[bitcast<u32>(select(0i, _e1136, (_e1136 > 0i)))];
let _e1143 = local_7[0u];
let _e1147 = local_7[0u];
let _e1150 = (_e1122 + ((_e1132 - _e1122) * _e1147));
let _e1151 = local_7[0u];
let _e1155 = (_e920 + _e915);
let _e1156 = local_6.member[1u];
let _e1157 = (_e1155 + _e1156);
let _e1159 = select(_e939, _e1157, (_e1157 < _e939));
let _e1164 = global_1.member[bitcast<u32>(select(0i, _e1159, (_e1159 > 0i)))];
let _e1165 = bitcast<f32>(_e1164);
let _e1166 = local_6.member[2u];
let _e1167 = (_e1155 + _e1166);
let _e1169 = select(_e939, _e1167, (_e1167 < _e939));
let _e1174 = global_1.member[bitcast<u32>(select(0i, _e1169, (_e1169 > 0i)))];
let _e1176 = local_7[0u];
let _e1179 = (_e1165 + ((bitcast<f32>(_e1174) - _e1165) * _e1176));
let _e1180 = (_e920 + _e918);
let _e1181 = local_6.member[1u];
let _e1182 = (_e1180 + _e1181);
let _e1184 = select(_e939, _e1182, (_e1182 < _e939));
let _e1189 = global_1.member[bitcast<u32>(select(0i, _e1184, (_e1184 > 0i)))];
let _e1190 = bitcast<f32>(_e1189);
let _e1191 = local_6.member[2u];
let _e1192 = (_e1180 + _e1191);
let _e1194 = select(_e939, _e1192, (_e1192 < _e939));
let _e1199 = global_1.member[bitcast<u32>(select(0i, _e1194, (_e1194 > 0i)))];
let _e1201 = local_7[0u];
let _e1205 = (_e921 + _e915);
let _e1206 = local_6.member[1u];
let _e1207 = (_e1205 + _e1206);
let _e1209 = select(_e939, _e1207, (_e1207 < _e939));
let _e1214 = global_1.member[bitcast<u32>(select(0i, _e1209, (_e1209 > 0i)))];
let _e1215 = bitcast<f32>(_e1214);
let _e1216 = local_6.member[2u];
let _e1217 = (_e1205 + _e1216);
let _e1219 = select(_e939, _e1217, (_e1217 < _e939));
let _e1224 = global_1.member[bitcast<u32>(select(0i, _e1219, (_e1219 > 0i)))];
let _e1226 = local_7[0u];
let _e1229 = (_e1215 + ((bitcast<f32>(_e1224) - _e1215) * _e1226));
let _e1230 = (_e921 + _e918);
let _e1231 = local_6.member[1u];
let _e1232 = (_e1230 + _e1231);
let _e1234 = select(_e939, _e1232, (_e1232 < _e939));
let _e1239 = global_1.member[bitcast<u32>(select(0i, _e1234, (_e1234 > 0i)))];
let _e1240 = bitcast<f32>(_e1239);
let _e1241 = local_6.member[2u];
let _e1242 = (_e1230 + _e1241);
let _e1244 = select(_e939, _e1242, (_e1242 < _e939));
let _e1249 = global_1.member[bitcast<u32>(select(0i, _e1244, (_e1244 > 0i)))];
let _e1251 = local_7[0u];
let _e1255 = (_e919 + _e916);
let _e1256 = local_6.member[1u];
let _e1257 = (_e1255 + _e1256);
let _e1259 = select(_e939, _e1257, (_e1257 < _e939));
let _e1264 = global_1.member[bitcast<u32>(select(0i, _e1259, (_e1259 > 0i)))];
let _e1265 = bitcast<f32>(_e1264);
let _e1266 = local_6.member[2u];
let _e1267 = (_e1255 + _e1266);
let _e1269 = select(_e939, _e1267, (_e1267 < _e939));
let _e1274 = global_1.member[bitcast<u32>(select(0i, _e1269, (_e1269 > 0i)))];
let _e1276 = local_7[0u];
let _e1279 = (_e1265 + ((bitcast<f32>(_e1274) - _e1265) * _e1276));
let _e1280 = (_e922 + _e916);
let _e1281 = local_6.member[1u];
let _e1282 = (_e1280 + _e1281);
let _e1284 = select(_e939, _e1282, (_e1282 < _e939));
let _e1289 = global_1.member[bitcast<u32>(select(0i, _e1284, (_e1284 > 0i)))];
let _e1290 = bitcast<f32>(_e1289);
let _e1291 = local_6.member[2u];
let _e1292 = (_e1280 + _e1291);
let _e1294 = select(_e939, _e1292, (_e1292 < _e939));
let _e1299 = global_1.member[bitcast<u32>(select(0i, _e1294, (_e1294 > 0i)))];
let _e1301 = local_7[0u];
let _e1304 = (_e1290 + ((bitcast<f32>(_e1299) - _e1290) * _e1301));
let _e1305 = (_e919 + _e917);
let _e1306 = local_6.member[1u];
let _e1307 = (_e1305 + _e1306);
let _e1309 = select(_e939, _e1307, (_e1307 < _e939));
let _e1314 = global_1.member[bitcast<u32>(select(0i, _e1309, (_e1309 > 0i)))];
let _e1315 = bitcast<f32>(_e1314);
let _e1316 = local_6.member[2u];
let _e1317 = (_e1305 + _e1316);
let _e1319 = select(_e939, _e1317, (_e1317 < _e939));
let _e1324 = global_1.member[bitcast<u32>(select(0i, _e1319, (_e1319 > 0i)))];
let _e1326 = local_7[0u];
let _e1330 = (_e922 + _e917);
let _e1331 = local_6.member[1u];
let _e1332 = (_e1330 + _e1331);
let _e1334 = select(_e939, _e1332, (_e1332 < _e939));
let _e1339 = global_1.member[bitcast<u32>(select(0i, _e1334, (_e1334 > 0i)))];
let _e1340 = bitcast<f32>(_e1339);
let _e1341 = local_6.member[2u];
let _e1342 = (_e1330 + _e1341);
let _e1344 = select(_e939, _e1342, (_e1342 < _e939));
let _e1349 = global_1.member[bitcast<u32>(select(0i, _e1344, (_e1344 > 0i)))];
let _e1351 = local_7[0u];
let _e1356 = local_7[1u];
let _e1359 = (_e991 + ((_e1044 - _e991) * _e1356));
let _e1360 = local_7[1u];
let _e1363 = (_e1097 + ((_e1150 - _e1097) * _e1360));
let _e1364 = local_7[1u];
let _e1367 = (_e987 + (((_e1006 + ((_e1016 - _e1006) * _e1037)) - _e987) * _e1364));
let _e1368 = local_7[1u];
let _e1373 = local_7[2u];
let _e1377 = local_7[1u];
let _e1380 = (_e995 + (((_e1026 + ((bitcast<f32>(_e1035) - _e1026) * _e1045)) - _e995) * _e1377));
let _e1381 = local_7[1u];
let _e1385 = local_7[2u];
let _e1389 = local_7[1u];
let _e1392 = (_e1179 + ((_e991 - _e1179) * _e1389));
let _e1393 = local_7[1u];
let _e1397 = local_7[2u];
let _e1401 = local_7[1u];
let _e1404 = (_e1044 + (((_e1190 + ((bitcast<f32>(_e1199) - _e1190) * _e1201)) - _e1044) * _e1401));
let _e1405 = local_7[1u];
let _e1409 = local_7[2u];
let _e1413 = local_7[1u];
let _e1416 = (_e1279 + (((_e1315 + ((bitcast<f32>(_e1324) - _e1315) * _e1326)) - _e1279) * _e1413));
let _e1417 = local_7[2u];
let _e1421 = local_7[1u];
let _e1425 = local_7[2u];
let _e1429 = local_7[2u];
let _e1437 = global_5.member[_e351].member_6.member_5;
let _e1443 = global_5.member[_e351].member_6.member_6;
let _e1444 = (((_e1359 + ((_e1363 - _e1359) * _e1429)) * _e1437) + _e1443);
let _e1446 = select(0f, _e1444, (_e1444 > 0f));
let _e1448 = select(1f, _e1446, (_e1446 < 1f));
let _e1450 = (((_e1367 + (((_e1093 + (((_e1112 + ((_e1122 - _e1112) * _e1143)) - _e1093) * _e1368)) - _e1367) * _e1373)) * _e1437) + _e1443);
let _e1452 = select(0f, _e1450, (_e1450 > 0f));
let _e1454 = select(1f, _e1452, (_e1452 < 1f));
let _e1456 = (((_e1380 + (((_e1101 + (((_e1132 + ((bitcast<f32>(_e1141) - _e1132) * _e1151)) - _e1101) * _e1381)) - _e1380) * _e1385)) * _e1437) + _e1443);
let _e1458 = select(0f, _e1456, (_e1456 > 0f));
let _e1460 = select(1f, _e1458, (_e1458 < 1f));
let _e1462 = (((_e1392 + (((_e1229 + ((_e1097 - _e1229) * _e1393)) - _e1392) * _e1397)) * _e1437) + _e1443);
let _e1464 = select(0f, _e1462, (_e1462 > 0f));
let _e1466 = select(1f, _e1464, (_e1464 < 1f));
let _e1468 = (((_e1404 + (((_e1150 + (((_e1240 + ((bitcast<f32>(_e1249) - _e1240) * _e1251)) - _e1150) * _e1405)) - _e1404) * _e1409)) * _e1437) + _e1443);
let _e1470 = select(0f, _e1468, (_e1468 > 0f));
let _e1472 = select(1f, _e1470, (_e1470 < 1f));
let _e1474 = (((_e1416 + ((_e1359 - _e1416) * _e1417)) * _e1437) + _e1443);
let _e1476 = select(0f, _e1474, (_e1474 > 0f));
let _e1478 = select(1f, _e1476, (_e1476 < 1f));
let _e1480 = (((_e1363 + (((_e1304 + (((_e1340 + ((bitcast<f32>(_e1349) - _e1340) * _e1351)) - _e1304) * _e1421)) - _e1363) * _e1425)) * _e1437) + _e1443);
let _e1482 = select(0f, _e1480, (_e1480 > 0f));
let _e1484 = select(1f, _e1482, (_e1482 < 1f));
let _e1485 = (_e1448 * 1024f);
let _e1486 = (1024f - 1f);
let _e1488 = select(0f, _e1485, (_e1485 > 0f));
let _e1490 = select(_e1486, _e1488, (_e1488 < _e1486));
let _e1497 = select(0i, select(select(i32(_e1490), i32(-2147483648), (_e1490 < -2147483600f)), 2147483647i, (_e1490 > 2147483500f)), (_e1490 == _e1490));
let _e1501 = (_e1497 - select(0i, 1i, (_e1490 < f32(_e1497))));
let _e1502 = (262147i + _e1501);
let _e1504 = (bitcast<i32>(_e122) - 1i);
let _e1506 = select(_e1504, _e1502, (_e1502 < _e1504));
let _e1512 = global_3.member[bitcast<u32>(select(0i, _e1506, (_e1506 > 0i)))];
let _e1522 = select(_e1504, 262146i, (262146i < _e1504));
let _e1528 = global_3.member[bitcast<u32>(select(0i, _e1522, (_e1522 > 0i)))];
let _e1529 = bitcast<f32>(_e1528);
let _e1530 = (f32((bitcast<i32>((_e1512 & 4095u)) - 2048i)) * _e1529);
let _e1532 = select(_e1504, 262144i, (262144i < _e1504));
let _e1538 = global_3.member[bitcast<u32>(select(0i, _e1532, (_e1532 > 0i)))];
let _e1539 = bitcast<f32>(_e1538);
let _e1541 = select(_e1504, 262145i, (262145i < _e1504));
let _e1547 = global_3.member[bitcast<u32>(select(0i, _e1541, (_e1541 > 0i)))];
let _e1548 = bitcast<f32>(_e1547);
let _e1554 = ((_e1539 + (f32(bitcast<i32>((_e1512 >> bitcast<u32>(12u)))) * _e1548)) + (_e1530 * (_e1485 - f32(_e1501))));
let _e1555 = (_e1530 * 1024f);
if _e799 {
let _e1562 = ((0.5f * (_e1460 - _e1454)) * _e1555);
let _e1563 = ((0.5f * (_e1472 - _e1466)) * _e1555);
let _e1564 = ((0.5f * (_e1484 - _e1478)) * _e1555);
phi_3483_ = type_29(_e1554, vec3<f32>(_e1562, _e1563, _e1564), vec3<f32>((_e1562 * _e1554), (_e1563 * _e1554), (_e1564 * _e1554)));
} else {
let _e1571 = (_e1454 * 1024f);
let _e1573 = select(0f, _e1571, (_e1571 > 0f));
let _e1575 = select(_e1486, _e1573, (_e1573 < _e1486));
let _e1582 = select(0i, select(select(i32(_e1575), i32(-2147483648), (_e1575 < -2147483600f)), 2147483647i, (_e1575 > 2147483500f)), (_e1575 == _e1575));
let _e1586 = (_e1582 - select(0i, 1i, (_e1575 < f32(_e1582))));
let _e1587 = (262147i + _e1586);
let _e1589 = select(_e1504, _e1587, (_e1587 < _e1504));
let _e1595 = global_3.member[bitcast<u32>(select(0i, _e1589, (_e1589 > 0i)))];
let _e1610 = ((_e1539 + (f32(bitcast<i32>((_e1595 >> bitcast<u32>(12u)))) * _e1548)) + ((f32((bitcast<i32>((_e1595 & 4095u)) - 2048i)) * _e1529) * (_e1571 - f32(_e1586))));
let _e1611 = (_e1460 * 1024f);
let _e1613 = select(0f, _e1611, (_e1611 > 0f));
let _e1615 = select(_e1486, _e1613, (_e1613 < _e1486));
let _e1622 = select(0i, select(select(i32(_e1615), i32(-2147483648), (_e1615 < -2147483600f)), 2147483647i, (_e1615 > 2147483500f)), (_e1615 == _e1615));
let _e1626 = (_e1622 - select(0i, 1i, (_e1615 < f32(_e1622))));
let _e1627 = (262147i + _e1626);
let _e1629 = select(_e1504, _e1627, (_e1627 < _e1504));
let _e1635 = global_3.member[bitcast<u32>(select(0i, _e1629, (_e1629 > 0i)))];
let _e1650 = ((_e1539 + (f32(bitcast<i32>((_e1635 >> bitcast<u32>(12u)))) * _e1548)) + ((f32((bitcast<i32>((_e1635 & 4095u)) - 2048i)) * _e1529) * (_e1611 - f32(_e1626))));
let _e1651 = (_e1466 * 1024f);
let _e1653 = select(0f, _e1651, (_e1651 > 0f));
let _e1655 = select(_e1486, _e1653, (_e1653 < _e1486));
let _e1662 = select(0i, select(select(i32(_e1655), i32(-2147483648), (_e1655 < -2147483600f)), 2147483647i, (_e1655 > 2147483500f)), (_e1655 == _e1655));
let _e1666 = (_e1662 - select(0i, 1i, (_e1655 < f32(_e1662))));
let _e1667 = (262147i + _e1666);
let _e1669 = select(_e1504, _e1667, (_e1667 < _e1504));
let _e1675 = global_3.member[bitcast<u32>(select(0i, _e1669, (_e1669 > 0i)))];
let _e1690 = ((_e1539 + (f32(bitcast<i32>((_e1675 >> bitcast<u32>(12u)))) * _e1548)) + ((f32((bitcast<i32>((_e1675 & 4095u)) - 2048i)) * _e1529) * (_e1651 - f32(_e1666))));
let _e1691 = (_e1472 * 1024f);
let _e1693 = select(0f, _e1691, (_e1691 > 0f));
let _e1695 = select(_e1486, _e1693, (_e1693 < _e1486));
let _e1702 = select(0i, select(select(i32(_e1695), i32(-2147483648), (_e1695 < -2147483600f)), 2147483647i, (_e1695 > 2147483500f)), (_e1695 == _e1695));
let _e1706 = (_e1702 - select(0i, 1i, (_e1695 < f32(_e1702))));
let _e1707 = (262147i + _e1706);
let _e1709 = select(_e1504, _e1707, (_e1707 < _e1504));
let _e1715 = global_3.member[bitcast<u32>(select(0i, _e1709, (_e1709 > 0i)))];
let _e1730 = ((_e1539 + (f32(bitcast<i32>((_e1715 >> bitcast<u32>(12u)))) * _e1548)) + ((f32((bitcast<i32>((_e1715 & 4095u)) - 2048i)) * _e1529) * (_e1691 - f32(_e1706))));
let _e1731 = (_e1478 * 1024f);
let _e1733 = select(0f, _e1731, (_e1731 > 0f));
let _e1735 = select(_e1486, _e1733, (_e1733 < _e1486));
let _e1742 = select(0i, select(select(i32(_e1735), i32(-2147483648), (_e1735 < -2147483600f)), 2147483647i, (_e1735 > 2147483500f)), (_e1735 == _e1735));
let _e1746 = (_e1742 - select(0i, 1i, (_e1735 < f32(_e1742))));
let _e1747 = (262147i + _e1746);
let _e1749 = select(_e1504, _e1747, (_e1747 < _e1504));
let _e1755 = global_3.member[bitcast<u32>(select(0i, _e1749, (_e1749 > 0i)))];
let _e1770 = ((_e1539 + (f32(bitcast<i32>((_e1755 >> bitcast<u32>(12u)))) * _e1548)) + ((f32((bitcast<i32>((_e1755 & 4095u)) - 2048i)) * _e1529) * (_e1731 - f32(_e1746))));
let _e1771 = (_e1484 * 1024f);
let _e1773 = select(0f, _e1771, (_e1771 > 0f));
let _e1775 = select(_e1486, _e1773, (_e1773 < _e1486));
let _e1782 = select(0i, select(select(i32(_e1775), i32(-2147483648), (_e1775 < -2147483600f)), 2147483647i, (_e1775 > 2147483500f)), (_e1775 == _e1775));
let _e1786 = (_e1782 - select(0i, 1i, (_e1775 < f32(_e1782))));
let _e1787 = (262147i + _e1786);
let _e1789 = select(_e1504, _e1787, (_e1787 < _e1504));
let _e1795 = global_3.member[bitcast<u32>(select(0i, _e1789, (_e1789 > 0i)))];
let _e1810 = ((_e1539 + (f32(bitcast<i32>((_e1795 >> bitcast<u32>(12u)))) * _e1548)) + ((f32((bitcast<i32>((_e1795 & 4095u)) - 2048i)) * _e1529) * (_e1771 - f32(_e1786))));
let _e1811 = (_e1650 - _e1610);
let _e1813 = (_e1730 - _e1690);
let _e1815 = (_e1810 - _e1770);
phi_3483_ = type_29(_e1554, vec3<f32>((0.5f * _e1811), (0.5f * _e1813), (0.5f * _e1815)), vec3<f32>((0.25f * (_e1811 * (_e1650 + _e1610))), (0.25f * (_e1813 * (_e1730 + _e1690))), (0.25f * (_e1815 * (_e1810 + _e1770)))));
}
let _e1830 = phi_3483_;
let _e1845 = select(0f, 1f, ((((((_e497 >= -0.5f) && (_e497 <= _e521)) && (_e503 >= -0.5f)) && (_e503 <= _e532)) && (_e509 >= -0.5f)) && (_e509 <= _e543)));
let _e1847 = (0.5f * (_e1460 - _e1454));
let _e1849 = (0.5f * (_e1472 - _e1466));
let _e1851 = (0.5f * (_e1484 - _e1478));
let _e1858 = global_5.member[_e351].member_6.member.member.member;
let _e1865 = global_5.member[_e351].member_6.member.member.member_1;
let _e1872 = global_5.member[_e351].member_6.member.member.member_2;
let _e1879 = global_5.member[_e351].member_6.member_1.member.member;
let _e1886 = global_5.member[_e351].member_6.member_1.member.member_1;
let _e1893 = global_5.member[_e351].member_6.member_1.member.member_2;
let _e1900 = global_5.member[_e351].member_6.member_2.member.member;
let _e1907 = global_5.member[_e351].member_6.member_2.member.member_1;
let _e1914 = global_5.member[_e351].member_6.member_2.member.member_2;
phi_4129_ = type_30(_e1448, vec3<f32>(((((_e1858 * _e1847) + (_e1879 * _e1849)) + (_e1900 * _e1851)) * _e1845), ((((_e1865 * _e1847) + (_e1886 * _e1849)) + (_e1907 * _e1851)) * _e1845), ((((_e1872 * _e1847) + (_e1893 * _e1849)) + (_e1914 * _e1851)) * _e1845)), _e1830.member, vec3<f32>(((((_e1858 * _e1830.member_2.x) + (_e1879 * _e1830.member_2.y)) + (_e1900 * _e1830.member_2.z)) * _e1845), ((((_e1865 * _e1830.member_2.x) + (_e1886 * _e1830.member_2.y)) + (_e1907 * _e1830.member_2.z)) * _e1845), ((((_e1872 * _e1830.member_2.x) + (_e1893 * _e1830.member_2.y)) + (_e1914 * _e1830.member_2.z)) * _e1845)), vec3<f32>(((((_e1858 * _e1830.member_1.x) + (_e1879 * _e1830.member_1.y)) + (_e1900 * _e1830.member_1.z)) * _e1845), ((((_e1865 * _e1830.member_1.x) + (_e1886 * _e1830.member_1.y)) + (_e1907 * _e1830.member_1.z)) * _e1845), ((((_e1872 * _e1830.member_1.x) + (_e1893 * _e1830.member_1.y)) + (_e1914 * _e1830.member_1.z)) * _e1845)));
} else {
let _e1980 = select(-1f, _e525, (_e525 > -1f));
let _e1982 = select(_e520, _e1980, (_e1980 < _e520));
let _e1989 = select(0i, select(select(i32(_e1982), i32(-2147483648), (_e1982 < -2147483600f)), 2147483647i, (_e1982 > 2147483500f)), (_e1982 == _e1982));
let _e1993 = (_e1989 - select(0i, 1i, (_e1982 < f32(_e1989))));
let _e1995 = select(-1f, _e536, (_e536 > -1f));
let _e1997 = select(_e531, _e1995, (_e1995 < _e531));
let _e2004 = select(0i, select(select(i32(_e1997), i32(-2147483648), (_e1997 < -2147483600f)), 2147483647i, (_e1997 > 2147483500f)), (_e1997 == _e1997));
let _e2008 = (_e2004 - select(0i, 1i, (_e1997 < f32(_e2004))));
let _e2010 = select(-1f, _e547, (_e547 > -1f));
let _e2012 = select(_e542, _e2010, (_e2010 < _e542));
let _e2019 = select(0i, select(select(i32(_e2012), i32(-2147483648), (_e2012 < -2147483600f)), 2147483647i, (_e2012 > 2147483500f)), (_e2012 == _e2012));
let _e2023 = (_e2019 - select(0i, 1i, (_e2012 < f32(_e2019))));
let _e2028 = global_5.member[_e351].member_6.member_7;
let _e2033 = global_5.member[_e351].member_6.member_8;
let _e2041 = (select(0i, select(select(i32(_e531), i32(-2147483648), (_e531 < -2147483600f)), 2147483647i, (_e531 > 2147483500f)), (_e531 == _e531)) - 1i);
let _e2044 = (_e2008 + 1i);
let _e2054 = (select(0i, select(select(i32(_e542), i32(-2147483648), (_e542 < -2147483600f)), 2147483647i, (_e542 > 2147483500f)), (_e542 == _e542)) - 1i);
let _e2057 = (_e2023 + 1i);
let _e2067 = (select(0i, select(select(i32(_e520), i32(-2147483648), (_e520 < -2147483600f)), 2147483647i, (_e520 > 2147483500f)), (_e520 == _e520)) - 1i);
let _e2068 = (_e1993 - 1i);
let _e2073 = (_e1993 + 1i);
let _e2076 = (_e1993 + 2i);
let _e2079 = (select(0i, _e2008, (_e2008 > 0i)) * _e2028);
let _e2080 = (select(_e2041, _e2044, (_e2044 < _e2041)) * _e2028);
let _e2081 = (select(0i, _e2023, (_e2023 > 0i)) * _e2033);
let _e2082 = (select(_e2054, _e2057, (_e2057 < _e2054)) * _e2033);
local_4 = type_28(array<i32, 4>(select(0i, _e2068, (_e2068 > 0i)), select(0i, _e1993, (_e1993 > 0i)), select(_e2067, _e2073, (_e2073 < _e2067)), select(_e2067, _e2076, (_e2076 < _e2067))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_5 = vec3<f32>((_e525 - f32(_e1993)), (_e536 - f32(_e2008)), (_e547 - f32(_e2023)));
let _e2093 = (_e2081 + _e2079);
let _e2096 = local_4.member[1u];
let _e2097 = (_e2093 + _e2096);
let _e2099 = (bitcast<i32>(_e118) - 1i);
let _e2101 = select(_e2099, _e2097, (_e2097 < _e2099));
let _e2106 = global_1.member[bitcast<u32>(select(0i, _e2101, (_e2101 > 0i)))];
let _e2107 = bitcast<f32>(_e2106);
let _e2110 = local_4.member[2u];
let _e2111 = (_e2093 + _e2110);
let _e2113 = select(_e2099, _e2111, (_e2111 < _e2099));
let _e2118 = global_1.member[bitcast<u32>(select(0i, _e2113, (_e2113 > 0i)))];
let _e2120 = local_5[0u];
let _e2123 = (_e2107 + ((bitcast<f32>(_e2118) - _e2107) * _e2120));
let _e2124 = (_e2081 + _e2080);
let _e2125 = local_4.member[1u];
let _e2126 = (_e2124 + _e2125);
let _e2128 = select(_e2099, _e2126, (_e2126 < _e2099));
let _e2133 = global_1.member[bitcast<u32>(select(0i, _e2128, (_e2128 > 0i)))];
let _e2134 = bitcast<f32>(_e2133);
let _e2135 = local_4.member[2u];
let _e2136 = (_e2124 + _e2135);
let _e2138 = select(_e2099, _e2136, (_e2136 < _e2099));
let _e2143 = global_1.member[bitcast<u32>(select(0i, _e2138, (_e2138 > 0i)))];
let _e2145 = local_5[0u];
let _e2150 = local_5[1u];
let _e2153 = (_e2123 + (((_e2134 + ((bitcast<f32>(_e2143) - _e2134) * _e2145)) - _e2123) * _e2150));
let _e2154 = (_e2082 + _e2079);
let _e2155 = local_4.member[1u];
let _e2156 = (_e2154 + _e2155);
let _e2158 = select(_e2099, _e2156, (_e2156 < _e2099));
let _e2163 = global_1.member[bitcast<u32>(select(0i, _e2158, (_e2158 > 0i)))];
let _e2164 = bitcast<f32>(_e2163);
let _e2165 = local_4.member[2u];
let _e2166 = (_e2154 + _e2165);
let _e2168 = select(_e2099, _e2166, (_e2166 < _e2099));
let _e2173 = global_1.member[bitcast<u32>(select(0i, _e2168, (_e2168 > 0i)))];
let _e2175 = local_5[0u];
let _e2178 = (_e2164 + ((bitcast<f32>(_e2173) - _e2164) * _e2175));
let _e2179 = (_e2082 + _e2080);
let _e2180 = local_4.member[1u];
let _e2181 = (_e2179 + _e2180);
let _e2183 = select(_e2099, _e2181, (_e2181 < _e2099));
let _e2188 = global_1.member[bitcast<u32>(select(0i, _e2183, (_e2183 > 0i)))];
let _e2189 = bitcast<f32>(_e2188);
let _e2190 = local_4.member[2u];
let _e2191 = (_e2179 + _e2190);
let _e2193 = select(_e2099, _e2191, (_e2191 < _e2099));
let _e2198 = global_1.member[bitcast<u32>(select(0i, _e2193, (_e2193 > 0i)))];
let _e2200 = local_5[0u];
let _e2204 = local_5[1u];
let _e2209 = local_5[2u];
let _e2217 = global_5.member[_e351].member_6.member_5;
let _e2223 = global_5.member[_e351].member_6.member_6;
let _e2224 = (((_e2153 + (((_e2178 + (((_e2189 + ((bitcast<f32>(_e2198) - _e2189) * _e2200)) - _e2178) * _e2204)) - _e2153) * _e2209)) * _e2217) + _e2223);
let _e2226 = select(0f, _e2224, (_e2224 > 0f));
phi_4129_ = type_30(select(1f, _e2226, (_e2226 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2231 = phi_4129_;
let _e2233 = select(-0.5f, _e459, (_e459 > -0.5f));
let _e2235 = select(_e521, _e2233, (_e2233 < _e521));
let _e2237 = select(-0.5f, _e475, (_e475 > -0.5f));
let _e2239 = select(_e532, _e2237, (_e2237 < _e532));
let _e2241 = select(-0.5f, _e491, (_e491 > -0.5f));
let _e2243 = select(_e543, _e2241, (_e2241 < _e543));
let _e2245 = select(-1f, _e2235, (_e2235 > -1f));
let _e2247 = select(_e520, _e2245, (_e2245 < _e520));
let _e2254 = select(0i, select(select(i32(_e2247), i32(-2147483648), (_e2247 < -2147483600f)), 2147483647i, (_e2247 > 2147483500f)), (_e2247 == _e2247));
let _e2258 = (_e2254 - select(0i, 1i, (_e2247 < f32(_e2254))));
let _e2260 = select(-1f, _e2239, (_e2239 > -1f));
let _e2262 = select(_e531, _e2260, (_e2260 < _e531));
let _e2269 = select(0i, select(select(i32(_e2262), i32(-2147483648), (_e2262 < -2147483600f)), 2147483647i, (_e2262 > 2147483500f)), (_e2262 == _e2262));
let _e2273 = (_e2269 - select(0i, 1i, (_e2262 < f32(_e2269))));
let _e2275 = select(-1f, _e2243, (_e2243 > -1f));
let _e2277 = select(_e542, _e2275, (_e2275 < _e542));
let _e2284 = select(0i, select(select(i32(_e2277), i32(-2147483648), (_e2277 < -2147483600f)), 2147483647i, (_e2277 > 2147483500f)), (_e2277 == _e2277));
let _e2288 = (_e2284 - select(0i, 1i, (_e2277 < f32(_e2284))));
let _e2293 = global_5.member[_e351].member_6.member_7;
let _e2298 = global_5.member[_e351].member_6.member_8;
let _e2306 = (select(0i, select(select(i32(_e531), i32(-2147483648), (_e531 < -2147483600f)), 2147483647i, (_e531 > 2147483500f)), (_e531 == _e531)) - 1i);
let _e2309 = (_e2273 + 1i);
let _e2319 = (select(0i, select(select(i32(_e542), i32(-2147483648), (_e542 < -2147483600f)), 2147483647i, (_e542 > 2147483500f)), (_e542 == _e542)) - 1i);
let _e2322 = (_e2288 + 1i);
let _e2332 = (select(0i, select(select(i32(_e520), i32(-2147483648), (_e520 < -2147483600f)), 2147483647i, (_e520 > 2147483500f)), (_e520 == _e520)) - 1i);
let _e2333 = (_e2258 - 1i);
let _e2338 = (_e2258 + 1i);
let _e2341 = (_e2258 + 2i);
let _e2344 = (select(0i, _e2273, (_e2273 > 0i)) * _e2293);
let _e2345 = (select(_e2306, _e2309, (_e2309 < _e2306)) * _e2293);
let _e2346 = (select(0i, _e2288, (_e2288 > 0i)) * _e2298);
let _e2347 = (select(_e2319, _e2322, (_e2322 < _e2319)) * _e2298);
local_2 = type_28(array<i32, 4>(select(0i, _e2333, (_e2333 > 0i)), select(0i, _e2258, (_e2258 > 0i)), select(_e2332, _e2338, (_e2338 < _e2332)), select(_e2332, _e2341, (_e2341 < _e2332))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = vec3<f32>((_e2235 - f32(_e2258)), (_e2239 - f32(_e2273)), (_e2243 - f32(_e2288)));
let _e2358 = (_e2346 + _e2344);
let _e2361 = local_2.member[1u];
let _e2362 = (_e2358 + _e2361);
let _e2364 = (bitcast<i32>(_e118) - 1i);
let _e2366 = select(_e2364, _e2362, (_e2362 < _e2364));
let _e2371 = global_1.member[bitcast<u32>(select(0i, _e2366, (_e2366 > 0i)))];
let _e2372 = bitcast<f32>(_e2371);
let _e2375 = local_2.member[2u];
let _e2376 = (_e2358 + _e2375);
let _e2378 = select(_e2364, _e2376, (_e2376 < _e2364));
let _e2383 = global_1.member[bitcast<u32>(select(0i, _e2378, (_e2378 > 0i)))];
let _e2385 = local_3[0u];
let _e2388 = (_e2372 + ((bitcast<f32>(_e2383) - _e2372) * _e2385));
let _e2389 = (_e2346 + _e2345);
let _e2390 = local_2.member[1u];
let _e2391 = (_e2389 + _e2390);
let _e2393 = select(_e2364, _e2391, (_e2391 < _e2364));
let _e2398 = global_1.member[bitcast<u32>(select(0i, _e2393, (_e2393 > 0i)))];
let _e2399 = bitcast<f32>(_e2398);
let _e2400 = local_2.member[2u];
let _e2401 = (_e2389 + _e2400);
let _e2403 = select(_e2364, _e2401, (_e2401 < _e2364));
let _e2408 = global_1.member[bitcast<u32>(select(0i, _e2403, (_e2403 > 0i)))];
let _e2410 = local_3[0u];
let _e2415 = local_3[1u];
let _e2418 = (_e2388 + (((_e2399 + ((bitcast<f32>(_e2408) - _e2399) * _e2410)) - _e2388) * _e2415));
let _e2419 = (_e2347 + _e2344);
let _e2420 = local_2.member[1u];
let _e2421 = (_e2419 + _e2420);
let _e2423 = select(_e2364, _e2421, (_e2421 < _e2364));
let _e2428 = global_1.member[bitcast<u32>(select(0i, _e2423, (_e2423 > 0i)))];
let _e2429 = bitcast<f32>(_e2428);
let _e2430 = local_2.member[2u];
let _e2431 = (_e2419 + _e2430);
let _e2433 = select(_e2364, _e2431, (_e2431 < _e2364));
let _e2438 = global_1.member[bitcast<u32>(select(0i, _e2433, (_e2433 > 0i)))];
let _e2440 = local_3[0u];
let _e2443 = (_e2429 + ((bitcast<f32>(_e2438) - _e2429) * _e2440));
let _e2444 = (_e2347 + _e2345);
let _e2445 = local_2.member[1u];
let _e2446 = (_e2444 + _e2445);
let _e2448 = select(_e2364, _e2446, (_e2446 < _e2364));
let _e2453 = global_1.member[bitcast<u32>(select(0i, _e2448, (_e2448 > 0i)))];
let _e2454 = bitcast<f32>(_e2453);
let _e2455 = local_2.member[2u];
let _e2456 = (_e2444 + _e2455);
let _e2458 = select(_e2364, _e2456, (_e2456 < _e2364));
let _e2463 = global_1.member[bitcast<u32>(select(0i, _e2458, (_e2458 > 0i)))];
let _e2465 = local_3[0u];
let _e2469 = local_3[1u];
let _e2474 = local_3[2u];
let _e2482 = global_5.member[_e351].member_6.member_5;
let _e2488 = global_5.member[_e351].member_6.member_6;
let _e2489 = (((_e2418 + (((_e2443 + (((_e2454 + ((bitcast<f32>(_e2463) - _e2454) * _e2465)) - _e2443) * _e2469)) - _e2418) * _e2474)) * _e2482) + _e2488);
let _e2491 = select(0f, _e2489, (_e2489 > 0f));
let _e2493 = select(1f, _e2491, (_e2491 < 1f));
let _e2494 = select(_e355[6], _e2493, _e718);
if _e802 {
let _e2495 = (_e2493 * 1024f);
let _e2496 = (1024f - 1f);
let _e2498 = select(0f, _e2495, (_e2495 > 0f));
let _e2500 = select(_e2496, _e2498, (_e2498 < _e2496));
let _e2507 = select(0i, select(select(i32(_e2500), i32(-2147483648), (_e2500 < -2147483600f)), 2147483647i, (_e2500 > 2147483500f)), (_e2500 == _e2500));
let _e2511 = (_e2507 - select(0i, 1i, (_e2500 < f32(_e2507))));
let _e2512 = (262147i + _e2511);
let _e2514 = (bitcast<i32>(_e122) - 1i);
let _e2516 = select(_e2514, _e2512, (_e2512 < _e2514));
let _e2522 = global_3.member[bitcast<u32>(select(0i, _e2516, (_e2516 > 0i)))];
let _e2532 = select(_e2514, 262146i, (262146i < _e2514));
let _e2538 = global_3.member[bitcast<u32>(select(0i, _e2532, (_e2532 > 0i)))];
let _e2542 = select(_e2514, 262144i, (262144i < _e2514));
let _e2548 = global_3.member[bitcast<u32>(select(0i, _e2542, (_e2542 > 0i)))];
let _e2551 = select(_e2514, 262145i, (262145i < _e2514));
let _e2557 = global_3.member[bitcast<u32>(select(0i, _e2551, (_e2551 > 0i)))];
phi_4712_ = select(_e355[16], ((bitcast<f32>(_e2548) + (f32(bitcast<i32>((_e2522 >> bitcast<u32>(12u)))) * bitcast<f32>(_e2557))) + ((f32((bitcast<i32>((_e2522 & 4095u)) - 2048i)) * bitcast<f32>(_e2538)) * (_e2495 - f32(_e2511)))), _e718);
} else {
phi_4712_ = _e355[16];
}
let _e2567 = phi_4712_;
let _e2570 = select(1f, select(1f, _e797, (_e797 < 1f)), _e443);
if ((_e686 & 16u) == 0u) {
phi_5101_ = type_5(1f, 1f, 1f);
} else {
let _e2577 = global_5.member[_e351].member_14.member;
let _e2588 = ((((_e2577.member.member * _e379) + (_e2577.member.member_1 * _e381)) + (_e2577.member.member_2 * _e375)) + _e2577.member_1);
let _e2594 = ((((_e2577.member.member * _e383) + (_e2577.member.member_1 * _e385)) + (_e2577.member.member_2 * _e390)) + _e2577.member_1);
let _e2596 = select(_e2594, _e2588, (_e2588 < _e2594));
let _e2598 = select(_e2594, _e2588, (_e2588 > _e2594));
let _e2600 = (_e2598 - _e2596);
let _e2603 = (-(_e2596) / select(1e-30f, _e2600, (_e2600 > 1e-30f)));
let _e2605 = select(0f, _e2603, (_e2603 > 0f));
let _e2611 = select(select(select(1f, _e2605, (_e2605 < 1f)), 1f, (_e2598 <= 0f)), 0f, (_e2596 > 0f));
let _e2617 = global_5.member[_e351].member_14.member_1;
let _e2618 = (_e2617 != 0u);
let _e2629 = global_5.member[_e351].member_15.member;
let _e2640 = ((((_e2629.member.member * _e379) + (_e2629.member.member_1 * _e381)) + (_e2629.member.member_2 * _e375)) + _e2629.member_1);
let _e2646 = ((((_e2629.member.member * _e383) + (_e2629.member.member_1 * _e385)) + (_e2629.member.member_2 * _e390)) + _e2629.member_1);
let _e2648 = select(_e2646, _e2640, (_e2640 < _e2646));
let _e2650 = select(_e2646, _e2640, (_e2640 > _e2646));
let _e2652 = (_e2650 - _e2648);
let _e2655 = (-(_e2648) / select(1e-30f, _e2652, (_e2652 > 1e-30f)));
let _e2657 = select(0f, _e2655, (_e2655 > 0f));
let _e2663 = select(select(select(1f, _e2657, (_e2657 < 1f)), 1f, (_e2650 <= 0f)), 0f, (_e2648 > 0f));
let _e2669 = global_5.member[_e351].member_15.member_1;
let _e2670 = (_e2669 != 0u);
let _e2681 = global_5.member[_e351].member_16.member;
let _e2692 = ((((_e2681.member.member * _e379) + (_e2681.member.member_1 * _e381)) + (_e2681.member.member_2 * _e375)) + _e2681.member_1);
let _e2698 = ((((_e2681.member.member * _e383) + (_e2681.member.member_1 * _e385)) + (_e2681.member.member_2 * _e390)) + _e2681.member_1);
let _e2700 = select(_e2698, _e2692, (_e2692 < _e2698));
let _e2702 = select(_e2698, _e2692, (_e2692 > _e2698));
let _e2704 = (_e2702 - _e2700);
let _e2707 = (-(_e2700) / select(1e-30f, _e2704, (_e2704 > 1e-30f)));
let _e2709 = select(0f, _e2707, (_e2707 > 0f));
let _e2715 = select(select(select(1f, _e2709, (_e2709 < 1f)), 1f, (_e2702 <= 0f)), 0f, (_e2700 > 0f));
let _e2721 = global_5.member[_e351].member_16.member_1;
let _e2722 = (_e2721 != 0u);
let _e2733 = global_5.member[_e351].member_17.member;
let _e2744 = ((((_e2733.member.member * _e379) + (_e2733.member.member_1 * _e381)) + (_e2733.member.member_2 * _e375)) + _e2733.member_1);
let _e2750 = ((((_e2733.member.member * _e383) + (_e2733.member.member_1 * _e385)) + (_e2733.member.member_2 * _e390)) + _e2733.member_1);
let _e2752 = select(_e2750, _e2744, (_e2744 < _e2750));
let _e2754 = select(_e2750, _e2744, (_e2744 > _e2750));
let _e2756 = (_e2754 - _e2752);
let _e2759 = (-(_e2752) / select(1e-30f, _e2756, (_e2756 > 1e-30f)));
let _e2761 = select(0f, _e2759, (_e2759 > 0f));
let _e2767 = select(select(select(1f, _e2761, (_e2761 < 1f)), 1f, (_e2754 <= 0f)), 0f, (_e2752 > 0f));
let _e2773 = global_5.member[_e351].member_17.member_1;
let _e2774 = (_e2773 != 0u);
phi_5101_ = type_5(((((1f * _e2611) * _e2663) * _e2715) * _e2767), ((((1f * select(1f, _e2611, _e2618)) * select(1f, _e2663, _e2670)) * select(1f, _e2715, _e2722)) * select(1f, _e2767, _e2774)), ((((1f * select(1f, 0f, (_e2618 && (_e2594 > 0f)))) * select(1f, 0f, (_e2670 && (_e2646 > 0f)))) * select(1f, 0f, (_e2722 && (_e2698 > 0f)))) * select(1f, 0f, (_e2774 && (_e2750 > 0f)))));
}
let _e2783 = phi_5101_;
let _e2784 = (_e553 < 1e-12f);
let _e2786 = (1f / select(_e548, 1f, _e2784));
let _e2788 = ((-0.5f - _e459) * _e2786);
let _e2790 = ((_e521 - _e459) * _e2786);
let _e2796 = select(_e2790, _e2788, (_e2788 < _e2790));
let _e2798 = select(0f, _e2796, (_e2796 > 0f));
let _e2801 = select(select(1f, _e2798, (_e2798 < 1f)), select(2f, 0f, ((_e459 >= -0.5f) && (_e459 <= _e521))), _e2784);
let _e2803 = select(_e2790, _e2788, (_e2788 > _e2790));
let _e2805 = select(0f, _e2803, (_e2803 > 0f));
let _e2808 = select(select(1f, _e2805, (_e2805 < 1f)), 1f, _e2784);
let _e2809 = (_e556 < 1e-12f);
let _e2811 = (1f / select(_e549, 1f, _e2809));
let _e2813 = ((-0.5f - _e475) * _e2811);
let _e2815 = ((_e532 - _e475) * _e2811);
let _e2821 = select(_e2815, _e2813, (_e2813 < _e2815));
let _e2823 = select(0f, _e2821, (_e2821 > 0f));
let _e2826 = select(select(1f, _e2823, (_e2823 < 1f)), select(2f, 0f, ((_e475 >= -0.5f) && (_e475 <= _e532))), _e2809);
let _e2828 = select(_e2815, _e2813, (_e2813 > _e2815));
let _e2830 = select(0f, _e2828, (_e2828 > 0f));
let _e2833 = select(select(1f, _e2830, (_e2830 < 1f)), 1f, _e2809);
let _e2834 = (_e561 < 1e-12f);
let _e2836 = (1f / select(_e550, 1f, _e2834));
let _e2838 = ((-0.5f - _e491) * _e2836);
let _e2840 = ((_e543 - _e491) * _e2836);
let _e2846 = select(_e2840, _e2838, (_e2838 < _e2840));
let _e2848 = select(0f, _e2846, (_e2846 > 0f));
let _e2851 = select(select(1f, _e2848, (_e2848 < 1f)), select(2f, 0f, ((_e491 >= -0.5f) && (_e491 <= _e543))), _e2834);
let _e2853 = select(_e2840, _e2838, (_e2838 > _e2840));
let _e2855 = select(0f, _e2853, (_e2853 > 0f));
let _e2858 = select(select(1f, _e2855, (_e2855 < 1f)), 1f, _e2834);
let _e2860 = select(_e2833, _e2808, (_e2808 < _e2833));
let _e2864 = select(_e2826, _e2801, (_e2801 > _e2826));
let _e2867 = (select(_e2858, _e2860, (_e2860 < _e2858)) - select(_e2851, _e2864, (_e2864 > _e2851)));
let _e2870 = (_e383 - _e379);
let _e2871 = (_e385 - _e381);
let _e2872 = (_e390 - _e375);
let _e2877 = (((_e2870 * _e2870) + (_e2871 * _e2871)) + (_e2872 * _e2872));
let _e2887 = global_5.member[_e351].member_5.member_3;
let _e2888 = (((sqrt(select(0f, _e2877, (_e2877 > 0f))) * select(0f, _e2867, (_e2867 > 0f))) * _e2570) * _e2887);
let _e2889 = (_e728.member_2 >= 3u);
if _e2889 {
let _e2891 = (_e2494 * 255f);
let _e2892 = (_e2231.member * 255f);
let _e2893 = (255f - 1f);
let _e2895 = select(0f, _e2891, (_e2891 > 0f));
let _e2897 = select(_e2893, _e2895, (_e2895 < _e2893));
let _e2904 = select(0i, select(select(i32(_e2897), i32(-2147483648), (_e2897 < -2147483600f)), 2147483647i, (_e2897 > 2147483500f)), (_e2897 == _e2897));
let _e2908 = (_e2904 - select(0i, 1i, (_e2897 < f32(_e2904))));
let _e2910 = select(0f, _e2892, (_e2892 > 0f));
let _e2912 = select(_e2893, _e2910, (_e2910 < _e2893));
let _e2919 = select(0i, select(select(i32(_e2912), i32(-2147483648), (_e2912 < -2147483600f)), 2147483647i, (_e2912 > 2147483500f)), (_e2912 == _e2912));
let _e2923 = (_e2919 - select(0i, 1i, (_e2912 < f32(_e2919))));
let _e2926 = (((_e2908 * 256i) + _e2923) * 4i);
let _e2928 = (_e2891 - f32(_e2908));
let _e2930 = (_e2892 - f32(_e2923));
let _e2931 = (_e2926 + 2i);
let _e2933 = (bitcast<i32>(_e122) - 1i);
let _e2935 = select(_e2933, _e2931, (_e2931 < _e2933));
let _e2941 = global_3.member[bitcast<u32>(select(0i, _e2935, (_e2935 > 0i)))];
let _e2942 = (_e2926 + 6i);
let _e2944 = select(_e2933, _e2942, (_e2942 < _e2933));
let _e2950 = global_3.member[bitcast<u32>(select(0i, _e2944, (_e2944 > 0i)))];
let _e2951 = (_e2926 + 1026i);
let _e2953 = select(_e2933, _e2951, (_e2951 < _e2933));
let _e2959 = global_3.member[bitcast<u32>(select(0i, _e2953, (_e2953 > 0i)))];
let _e2960 = (_e2926 + 1030i);
let _e2962 = select(_e2933, _e2960, (_e2960 < _e2933));
let _e2968 = global_3.member[bitcast<u32>(select(0i, _e2962, (_e2962 > 0i)))];
let _e2973 = (bitcast<f32>(((_e2941 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2981 = (_e2973 + (((bitcast<f32>(((_e2950 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2973) * _e2930));
let _e2986 = (bitcast<f32>(((_e2959 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3010 = (bitcast<f32>((((_e2941 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3018 = (_e3010 + (((bitcast<f32>((((_e2950 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3010) * _e2930));
let _e3023 = (bitcast<f32>((((_e2959 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3035 = (_e2926 + 3i);
let _e3037 = select(_e2933, _e3035, (_e3035 < _e2933));
let _e3043 = global_3.member[bitcast<u32>(select(0i, _e3037, (_e3037 > 0i)))];
let _e3044 = (_e2926 + 7i);
let _e3046 = select(_e2933, _e3044, (_e3044 < _e2933));
let _e3052 = global_3.member[bitcast<u32>(select(0i, _e3046, (_e3046 > 0i)))];
let _e3053 = (_e2926 + 1027i);
let _e3055 = select(_e2933, _e3053, (_e3053 < _e2933));
let _e3061 = global_3.member[bitcast<u32>(select(0i, _e3055, (_e3055 > 0i)))];
let _e3062 = (_e2926 + 1031i);
let _e3064 = select(_e2933, _e3062, (_e3062 < _e2933));
let _e3070 = global_3.member[bitcast<u32>(select(0i, _e3064, (_e3064 > 0i)))];
let _e3075 = (bitcast<f32>(((_e3043 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3083 = (_e3075 + (((bitcast<f32>(((_e3052 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3075) * _e2930));
let _e3088 = (bitcast<f32>(((_e3061 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3112 = (bitcast<f32>((((_e3043 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3120 = (_e3112 + (((bitcast<f32>((((_e3052 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3112) * _e2930));
let _e3125 = (bitcast<f32>((((_e3061 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3136 = (_e3120 + (((_e3125 + (((bitcast<f32>((((_e3070 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3125) * _e2930)) - _e3120) * _e2928));
let _e3140 = -((_e3136 * (_e2888 * _e2783.member)));
let _e3142 = select(-87f, _e3140, (_e3140 > -87f));
let _e3144 = select(88f, _e3142, (_e3142 < 88f));
let _e3146 = ((_e3144 * 1.442695f) + 0.5f);
let _e3148 = select(-127f, _e3146, (_e3146 > -127f));
let _e3150 = select(128f, _e3148, (_e3148 < 128f));
let _e3157 = select(0i, select(select(i32(_e3150), i32(-2147483648), (_e3150 < -2147483600f)), 2147483647i, (_e3150 > 2147483500f)), (_e3150 == _e3150));
let _e3161 = (_e3157 - select(0i, 1i, (_e3150 < f32(_e3157))));
let _e3162 = f32(_e3161);
let _e3166 = ((_e3144 - (_e3162 * 0.6933594f)) - (_e3162 * -2.1219444e-4f));
let _e3186 = ((1f + (_e3166 * (1f + (_e3166 * (0.5f + (_e3166 * (0.16666667f + (_e3166 * (0.041666668f + (_e3166 * (0.008333334f + (_e3166 * (0.001388889f + (_e3166 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3161 + 127i)) << bitcast<u32>(23i))));
let _e3187 = (1f - _e3186);
let _e3190 = (_e3187 / select(1e-12f, _e3136, (_e3136 > 1e-12f)));
phi_6659_ = type_31(_e3186, _e3187, vec3<f32>(1f, 1f, 1f), vec3<f32>(((_e2981 + (((_e2986 + (((bitcast<f32>(((_e2968 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2986) * _e2930)) - _e2981) * _e2928)) * _e3190), ((_e3018 + (((_e3023 + (((bitcast<f32>((((_e2968 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3023) * _e2930)) - _e3018) * _e2928)) * _e3190), ((_e3083 + (((_e3088 + (((bitcast<f32>(((_e3070 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3088) * _e2930)) - _e3083) * _e2928)) * _e3190)));
} else {
let _e3197 = (_e2494 * 255f);
let _e3198 = (_e2231.member * 255f);
let _e3199 = (255f - 1f);
let _e3201 = select(0f, _e3197, (_e3197 > 0f));
let _e3203 = select(_e3199, _e3201, (_e3201 < _e3199));
let _e3210 = select(0i, select(select(i32(_e3203), i32(-2147483648), (_e3203 < -2147483600f)), 2147483647i, (_e3203 > 2147483500f)), (_e3203 == _e3203));
let _e3214 = (_e3210 - select(0i, 1i, (_e3203 < f32(_e3210))));
let _e3216 = select(0f, _e3198, (_e3198 > 0f));
let _e3218 = select(_e3199, _e3216, (_e3216 < _e3199));
let _e3225 = select(0i, select(select(i32(_e3218), i32(-2147483648), (_e3218 < -2147483600f)), 2147483647i, (_e3218 > 2147483500f)), (_e3218 == _e3218));
let _e3229 = (_e3225 - select(0i, 1i, (_e3218 < f32(_e3225))));
let _e3232 = (((_e3214 * 256i) + _e3229) * 4i);
let _e3234 = (_e3197 - f32(_e3214));
let _e3236 = (_e3198 - f32(_e3229));
let _e3238 = (bitcast<i32>(_e122) - 1i);
let _e3240 = select(_e3238, _e3232, (_e3232 < _e3238));
let _e3246 = global_3.member[bitcast<u32>(select(0i, _e3240, (_e3240 > 0i)))];
let _e3247 = (_e3232 + 4i);
let _e3249 = select(_e3238, _e3247, (_e3247 < _e3238));
let _e3255 = global_3.member[bitcast<u32>(select(0i, _e3249, (_e3249 > 0i)))];
let _e3256 = (_e3232 + 1024i);
let _e3258 = select(_e3238, _e3256, (_e3256 < _e3238));
let _e3264 = global_3.member[bitcast<u32>(select(0i, _e3258, (_e3258 > 0i)))];
let _e3265 = (_e3232 + 1028i);
let _e3267 = select(_e3238, _e3265, (_e3265 < _e3238));
let _e3273 = global_3.member[bitcast<u32>(select(0i, _e3267, (_e3267 > 0i)))];
let _e3278 = (bitcast<f32>(((_e3246 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3286 = (_e3278 + (((bitcast<f32>(((_e3255 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3278) * _e3236));
let _e3291 = (bitcast<f32>(((_e3264 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3302 = (_e3286 + (((_e3291 + (((bitcast<f32>(((_e3273 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3291) * _e3236)) - _e3286) * _e3234));
let _e3315 = (bitcast<f32>((((_e3246 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3323 = (_e3315 + (((bitcast<f32>((((_e3255 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3315) * _e3236));
let _e3328 = (bitcast<f32>((((_e3264 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3340 = (_e3232 + 1i);
let _e3342 = select(_e3238, _e3340, (_e3340 < _e3238));
let _e3348 = global_3.member[bitcast<u32>(select(0i, _e3342, (_e3342 > 0i)))];
let _e3349 = (_e3232 + 5i);
let _e3351 = select(_e3238, _e3349, (_e3349 < _e3238));
let _e3357 = global_3.member[bitcast<u32>(select(0i, _e3351, (_e3351 > 0i)))];
let _e3358 = (_e3232 + 1025i);
let _e3360 = select(_e3238, _e3358, (_e3358 < _e3238));
let _e3366 = global_3.member[bitcast<u32>(select(0i, _e3360, (_e3360 > 0i)))];
let _e3367 = (_e3232 + 1029i);
let _e3369 = select(_e3238, _e3367, (_e3367 < _e3238));
let _e3375 = global_3.member[bitcast<u32>(select(0i, _e3369, (_e3369 > 0i)))];
let _e3380 = (bitcast<f32>(((_e3348 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3388 = (_e3380 + (((bitcast<f32>(((_e3357 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3380) * _e3236));
let _e3393 = (bitcast<f32>(((_e3366 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3417 = (bitcast<f32>((((_e3348 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3425 = (_e3417 + (((bitcast<f32>((((_e3357 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3417) * _e3236));
let _e3430 = (bitcast<f32>((((_e3366 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3442 = (_e3232 + 2i);
let _e3444 = select(_e3238, _e3442, (_e3442 < _e3238));
let _e3450 = global_3.member[bitcast<u32>(select(0i, _e3444, (_e3444 > 0i)))];
let _e3451 = (_e3232 + 6i);
let _e3453 = select(_e3238, _e3451, (_e3451 < _e3238));
let _e3459 = global_3.member[bitcast<u32>(select(0i, _e3453, (_e3453 > 0i)))];
let _e3460 = (_e3232 + 1026i);
let _e3462 = select(_e3238, _e3460, (_e3460 < _e3238));
let _e3468 = global_3.member[bitcast<u32>(select(0i, _e3462, (_e3462 > 0i)))];
let _e3469 = (_e3232 + 1030i);
let _e3471 = select(_e3238, _e3469, (_e3469 < _e3238));
let _e3477 = global_3.member[bitcast<u32>(select(0i, _e3471, (_e3471 > 0i)))];
let _e3482 = (bitcast<f32>(((_e3450 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3490 = (_e3482 + (((bitcast<f32>(((_e3459 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3482) * _e3236));
let _e3495 = (bitcast<f32>(((_e3468 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3519 = (bitcast<f32>((((_e3450 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3527 = (_e3519 + (((bitcast<f32>((((_e3459 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3519) * _e3236));
let _e3532 = (bitcast<f32>((((_e3468 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3544 = (_e3232 + 3i);
let _e3546 = select(_e3238, _e3544, (_e3544 < _e3238));
let _e3552 = global_3.member[bitcast<u32>(select(0i, _e3546, (_e3546 > 0i)))];
let _e3553 = (_e3232 + 7i);
let _e3555 = select(_e3238, _e3553, (_e3553 < _e3238));
let _e3561 = global_3.member[bitcast<u32>(select(0i, _e3555, (_e3555 > 0i)))];
let _e3562 = (_e3232 + 1027i);
let _e3564 = select(_e3238, _e3562, (_e3562 < _e3238));
let _e3570 = global_3.member[bitcast<u32>(select(0i, _e3564, (_e3564 > 0i)))];
let _e3571 = (_e3232 + 1031i);
let _e3573 = select(_e3238, _e3571, (_e3571 < _e3238));
let _e3579 = global_3.member[bitcast<u32>(select(0i, _e3573, (_e3573 > 0i)))];
let _e3584 = (bitcast<f32>(((_e3552 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3592 = (_e3584 + (((bitcast<f32>(((_e3561 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3584) * _e3236));
let _e3597 = (bitcast<f32>(((_e3570 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3612 = (_e2888 * _e2783.member_1);
let _e3614 = -(((_e3323 + (((_e3328 + (((bitcast<f32>((((_e3273 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3328) * _e3236)) - _e3323) * _e3234)) * _e3612));
let _e3616 = select(-87f, _e3614, (_e3614 > -87f));
let _e3618 = select(88f, _e3616, (_e3616 < 88f));
let _e3620 = ((_e3618 * 1.442695f) + 0.5f);
let _e3622 = select(-127f, _e3620, (_e3620 > -127f));
let _e3624 = select(128f, _e3622, (_e3622 < 128f));
let _e3631 = select(0i, select(select(i32(_e3624), i32(-2147483648), (_e3624 < -2147483600f)), 2147483647i, (_e3624 > 2147483500f)), (_e3624 == _e3624));
let _e3635 = (_e3631 - select(0i, 1i, (_e3624 < f32(_e3631))));
let _e3636 = f32(_e3635);
let _e3640 = ((_e3618 - (_e3636 * 0.6933594f)) - (_e3636 * -2.1219444e-4f));
let _e3662 = -(((_e3388 + (((_e3393 + (((bitcast<f32>(((_e3375 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3393) * _e3236)) - _e3388) * _e3234)) * _e3612));
let _e3664 = select(-87f, _e3662, (_e3662 > -87f));
let _e3666 = select(88f, _e3664, (_e3664 < 88f));
let _e3668 = ((_e3666 * 1.442695f) + 0.5f);
let _e3670 = select(-127f, _e3668, (_e3668 > -127f));
let _e3672 = select(128f, _e3670, (_e3670 < 128f));
let _e3679 = select(0i, select(select(i32(_e3672), i32(-2147483648), (_e3672 < -2147483600f)), 2147483647i, (_e3672 > 2147483500f)), (_e3672 == _e3672));
let _e3683 = (_e3679 - select(0i, 1i, (_e3672 < f32(_e3679))));
let _e3684 = f32(_e3683);
let _e3688 = ((_e3666 - (_e3684 * 0.6933594f)) - (_e3684 * -2.1219444e-4f));
let _e3710 = -(((_e3425 + (((_e3430 + (((bitcast<f32>((((_e3375 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3430) * _e3236)) - _e3425) * _e3234)) * _e3612));
let _e3712 = select(-87f, _e3710, (_e3710 > -87f));
let _e3714 = select(88f, _e3712, (_e3712 < 88f));
let _e3716 = ((_e3714 * 1.442695f) + 0.5f);
let _e3718 = select(-127f, _e3716, (_e3716 > -127f));
let _e3720 = select(128f, _e3718, (_e3718 < 128f));
let _e3727 = select(0i, select(select(i32(_e3720), i32(-2147483648), (_e3720 < -2147483600f)), 2147483647i, (_e3720 > 2147483500f)), (_e3720 == _e3720));
let _e3731 = (_e3727 - select(0i, 1i, (_e3720 < f32(_e3727))));
let _e3732 = f32(_e3731);
let _e3736 = ((_e3714 - (_e3732 * 0.6933594f)) - (_e3732 * -2.1219444e-4f));
let _e3759 = -((_e3302 * (_e2888 * _e2783.member)));
let _e3761 = select(-87f, _e3759, (_e3759 > -87f));
let _e3763 = select(88f, _e3761, (_e3761 < 88f));
let _e3765 = ((_e3763 * 1.442695f) + 0.5f);
let _e3767 = select(-127f, _e3765, (_e3765 > -127f));
let _e3769 = select(128f, _e3767, (_e3767 < 128f));
let _e3776 = select(0i, select(select(i32(_e3769), i32(-2147483648), (_e3769 < -2147483600f)), 2147483647i, (_e3769 > 2147483500f)), (_e3769 == _e3769));
let _e3780 = (_e3776 - select(0i, 1i, (_e3769 < f32(_e3776))));
let _e3781 = f32(_e3780);
let _e3785 = ((_e3763 - (_e3781 * 0.6933594f)) - (_e3781 * -2.1219444e-4f));
let _e3805 = ((1f + (_e3785 * (1f + (_e3785 * (0.5f + (_e3785 * (0.16666667f + (_e3785 * (0.041666668f + (_e3785 * (0.008333334f + (_e3785 * (0.001388889f + (_e3785 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3780 + 127i)) << bitcast<u32>(23i))));
let _e3806 = (1f - _e3805);
let _e3809 = (_e3806 / select(1e-12f, _e3302, (_e3302 > 1e-12f)));
phi_6659_ = type_31(_e3805, _e3806, vec3<f32>(((1f + (_e3640 * (1f + (_e3640 * (0.5f + (_e3640 * (0.16666667f + (_e3640 * (0.041666668f + (_e3640 * (0.008333334f + (_e3640 * (0.001388889f + (_e3640 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3635 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3688 * (1f + (_e3688 * (0.5f + (_e3688 * (0.16666667f + (_e3688 * (0.041666668f + (_e3688 * (0.008333334f + (_e3688 * (0.001388889f + (_e3688 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3683 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3736 * (1f + (_e3736 * (0.5f + (_e3736 * (0.16666667f + (_e3736 * (0.041666668f + (_e3736 * (0.008333334f + (_e3736 * (0.001388889f + (_e3736 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3731 + 127i)) << bitcast<u32>(23i))))), vec3<f32>(((_e3490 + (((_e3495 + (((bitcast<f32>(((_e3477 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3495) * _e3236)) - _e3490) * _e3234)) * _e3809), ((_e3527 + (((_e3532 + (((bitcast<f32>((((_e3477 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3532) * _e3236)) - _e3527) * _e3234)) * _e3809), ((_e3592 + (((_e3597 + (((bitcast<f32>(((_e3579 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3597) * _e3236)) - _e3592) * _e3234)) * _e3809)));
}
let _e3816 = phi_6659_;
let _e3817 = select(0f, _e2570, _e443);
let _e3821 = (_e379 + (_e2870 * _e3817));
let _e3822 = (_e381 + (_e2871 * _e3817));
let _e3823 = (_e375 + (_e2872 * _e3817));
if (_e728.member_2 == 3u) {
let _e3829 = global_5.member[_e351].member_9.member_1;
let _e3838 = global_5.member[_e351].member_9.member;
phi_7642_ = type_25(vec3<f32>(_e3829.member, _e3829.member_1, _e3829.member_2), vec3<f32>(_e3838.member, _e3838.member_1, _e3838.member_2));
} else {
let _e3848 = global_5.member[_e351].member_8.member_8;
let _e3849 = (_e3823 - _e3848);
let _e3854 = global_5.member[_e351].member_8.member_2;
let _e3859 = global_5.member[_e351].member_8.member_6;
let _e3867 = global_5.member[_e351].member_8.member_5;
let _e3869 = (((_e3821 - (_e3854 + (_e3859 * _e3849))) * _e3867) - 0.5f);
let _e3874 = global_5.member[_e351].member_8.member_3;
let _e3879 = global_5.member[_e351].member_8.member_7;
let _e3884 = (((_e3822 - (_e3874 + (_e3879 * _e3849))) * _e3867) - 0.5f);
let _e3889 = global_5.member[_e351].member_8.member;
let _e3890 = bitcast<i32>(_e3889);
let _e3892 = (f32(_e3890) - 1f);
let _e3897 = global_5.member[_e351].member_8.member_1;
let _e3900 = (f32(bitcast<i32>(_e3897)) - 1f);
let _e3902 = select(0f, _e3869, (_e3869 > 0f));
let _e3904 = select(_e3892, _e3902, (_e3902 < _e3892));
let _e3911 = select(0i, select(select(i32(_e3904), i32(-2147483648), (_e3904 < -2147483600f)), 2147483647i, (_e3904 > 2147483500f)), (_e3904 == _e3904));
let _e3915 = (_e3911 - select(0i, 1i, (_e3904 < f32(_e3911))));
let _e3917 = select(0f, _e3884, (_e3884 > 0f));
let _e3919 = select(_e3900, _e3917, (_e3917 < _e3900));
let _e3926 = select(0i, select(select(i32(_e3919), i32(-2147483648), (_e3919 < -2147483600f)), 2147483647i, (_e3919 > 2147483500f)), (_e3919 == _e3919));
let _e3930 = (_e3926 - select(0i, 1i, (_e3919 < f32(_e3926))));
let _e3934 = (_e3869 - f32(_e3915));
let _e3936 = (_e3884 - f32(_e3930));
let _e3943 = ((((_e3869 >= 0f) && (_e3869 <= _e3892)) && (_e3884 >= 0f)) && (_e3884 <= _e3900));
let _e3947 = global_5.member[_e351].member_4;
let _e3948 = bitcast<i32>(_e3947);
let _e3950 = bitcast<i32>((_e3889 * _e3897));
let _e3952 = (_e3948 + (3i * _e3950));
local_1 = (_e3952 + ((_e3930 * _e3890) + _e3915));
let _e3954 = local_1;
let _e3956 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e3958 = select(_e3956, _e3954, (_e3954 < _e3956));
let _e3963 = global_6.member[bitcast<u32>(select(0i, _e3958, (_e3958 > 0i)))];
let _e3964 = bitcast<u32>(_e3963);
let _e3968 = f32((bitcast<i32>((_e3964 & 65535u)) - 32768i));
let _e3974 = f32((bitcast<i32>(((_e3964 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e3979 = select(_e3974, -(_e3974), ((_e3964 >> bitcast<u32>(31i)) != 0u));
let _e3980 = local_1;
let _e3981 = (_e3980 + 1i);
let _e3983 = select(_e3956, _e3981, (_e3981 < _e3956));
let _e3988 = global_6.member[bitcast<u32>(select(0i, _e3983, (_e3983 > 0i)))];
let _e3989 = bitcast<u32>(_e3988);
let _e3999 = f32((bitcast<i32>(((_e3989 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4005 = local_1;
let _e4006 = (_e4005 + _e3890);
let _e4008 = select(_e3956, _e4006, (_e4006 < _e3956));
let _e4013 = global_6.member[bitcast<u32>(select(0i, _e4008, (_e4008 > 0i)))];
let _e4014 = bitcast<u32>(_e4013);
let _e4018 = f32((bitcast<i32>((_e4014 & 65535u)) - 32768i));
let _e4024 = f32((bitcast<i32>(((_e4014 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4029 = select(_e4024, -(_e4024), ((_e4014 >> bitcast<u32>(31i)) != 0u));
let _e4030 = (_e3890 + 1i);
let _e4031 = local_1;
let _e4032 = (_e4031 + _e4030);
let _e4034 = select(_e3956, _e4032, (_e4032 < _e3956));
let _e4039 = global_6.member[bitcast<u32>(select(0i, _e4034, (_e4034 > 0i)))];
let _e4040 = bitcast<u32>(_e4039);
let _e4050 = f32((bitcast<i32>(((_e4040 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4058 = (_e3968 + ((f32((bitcast<i32>((_e3989 & 65535u)) - 32768i)) - _e3968) * _e3934));
let _e4067 = (_e3979 + ((select(_e3999, -(_e3999), ((_e3989 >> bitcast<u32>(31i)) != 0u)) - _e3979) * _e3934));
let _e4080 = global_5.member[_e351].member_9.member;
let _e4083 = (1f / 16255f);
let _e4085 = (_e4080.member + (select(0f, (_e4058 + (((_e4018 + ((f32((bitcast<i32>((_e4040 & 65535u)) - 32768i)) - _e4018) * _e3934)) - _e4058) * _e3936)), _e3943) * _e4083));
let _e4087 = (_e4080.member_1 + (select(0f, (_e4067 + (((_e4029 + ((select(_e4050, -(_e4050), ((_e4040 >> bitcast<u32>(31i)) != 0u)) - _e4029) * _e3934)) - _e4067) * _e3936)), _e3943) * _e4083));
let _e4091 = (1f - ((_e4085 * _e4085) + (_e4087 * _e4087)));
let _e4093 = select(1e-4f, _e4091, (_e4091 > 1e-4f));
let _e4096 = sqrt(select(0f, _e4093, (_e4093 > 0f)));
let _e4100 = (1f / select(1e-6f, _e4096, (_e4096 > 1e-6f)));
let _e4101 = ((_e3823 - _e375) * _e3867);
let _e4108 = (_e3869 - (((_e4085 * _e4100) - _e3859) * _e4101));
let _e4109 = (_e3884 - (((_e4087 * _e4100) - _e3879) * _e4101));
let _e4111 = select(0f, _e4108, (_e4108 > 0f));
let _e4113 = select(_e3892, _e4111, (_e4111 < _e3892));
let _e4120 = select(0i, select(select(i32(_e4113), i32(-2147483648), (_e4113 < -2147483600f)), 2147483647i, (_e4113 > 2147483500f)), (_e4113 == _e4113));
let _e4124 = (_e4120 - select(0i, 1i, (_e4113 < f32(_e4120))));
let _e4126 = select(0f, _e4109, (_e4109 > 0f));
let _e4128 = select(_e3900, _e4126, (_e4126 < _e3900));
let _e4135 = select(0i, select(select(i32(_e4128), i32(-2147483648), (_e4128 < -2147483600f)), 2147483647i, (_e4128 > 2147483500f)), (_e4128 == _e4128));
let _e4139 = (_e4135 - select(0i, 1i, (_e4128 < f32(_e4135))));
let _e4141 = ((_e4139 * _e3890) + _e4124);
let _e4143 = (_e4108 - f32(_e4124));
let _e4145 = (_e4109 - f32(_e4139));
let _e4152 = ((((_e4108 >= 0f) && (_e4108 <= _e3892)) && (_e4109 >= 0f)) && (_e4109 <= _e3900));
let _e4153 = (_e3948 + _e4141);
let _e4155 = select(_e3956, _e4153, (_e4153 < _e3956));
let _e4161 = global_6.member[bitcast<u32>(select(0i, _e4155, (_e4155 > 0i)))];
let _e4162 = (_e4153 + 1i);
let _e4164 = select(_e3956, _e4162, (_e4162 < _e3956));
let _e4170 = global_6.member[bitcast<u32>(select(0i, _e4164, (_e4164 > 0i)))];
let _e4173 = (_e4161 + ((_e4170 - _e4161) * _e4143));
let _e4174 = (_e4153 + _e3890);
let _e4176 = select(_e3956, _e4174, (_e4174 < _e3956));
let _e4182 = global_6.member[bitcast<u32>(select(0i, _e4176, (_e4176 > 0i)))];
let _e4183 = (_e4174 + 1i);
let _e4185 = select(_e3956, _e4183, (_e4183 < _e3956));
let _e4191 = global_6.member[bitcast<u32>(select(0i, _e4185, (_e4185 > 0i)))];
let _e4198 = select(1f, (_e4173 + (((_e4182 + ((_e4191 - _e4182) * _e4143)) - _e4173) * _e4145)), _e4152);
if _e2889 {
phi_7412_ = vec3(_e4198);
} else {
let _e4201 = ((_e3948 + _e3950) + _e4141);
let _e4203 = select(_e3956, _e4201, (_e4201 < _e3956));
let _e4209 = global_6.member[bitcast<u32>(select(0i, _e4203, (_e4203 > 0i)))];
let _e4210 = (_e4201 + 1i);
let _e4212 = select(_e3956, _e4210, (_e4210 < _e3956));
let _e4218 = global_6.member[bitcast<u32>(select(0i, _e4212, (_e4212 > 0i)))];
let _e4221 = (_e4209 + ((_e4218 - _e4209) * _e4143));
let _e4222 = (_e4201 + _e3890);
let _e4224 = select(_e3956, _e4222, (_e4222 < _e3956));
let _e4230 = global_6.member[bitcast<u32>(select(0i, _e4224, (_e4224 > 0i)))];
let _e4231 = (_e4222 + 1i);
let _e4233 = select(_e3956, _e4231, (_e4231 < _e3956));
let _e4239 = global_6.member[bitcast<u32>(select(0i, _e4233, (_e4233 > 0i)))];
let _e4249 = ((_e3948 + (2i * _e3950)) + _e4141);
let _e4251 = select(_e3956, _e4249, (_e4249 < _e3956));
let _e4257 = global_6.member[bitcast<u32>(select(0i, _e4251, (_e4251 > 0i)))];
let _e4258 = (_e4249 + 1i);
let _e4260 = select(_e3956, _e4258, (_e4258 < _e3956));
let _e4266 = global_6.member[bitcast<u32>(select(0i, _e4260, (_e4260 > 0i)))];
let _e4269 = (_e4257 + ((_e4266 - _e4257) * _e4143));
let _e4270 = (_e4249 + _e3890);
let _e4272 = select(_e3956, _e4270, (_e4270 < _e3956));
let _e4278 = global_6.member[bitcast<u32>(select(0i, _e4272, (_e4272 > 0i)))];
let _e4279 = (_e4270 + 1i);
let _e4281 = select(_e3956, _e4279, (_e4279 < _e3956));
let _e4287 = global_6.member[bitcast<u32>(select(0i, _e4281, (_e4281 > 0i)))];
phi_7412_ = vec3<f32>(_e4198, select(1f, (_e4221 + (((_e4230 + ((_e4239 - _e4230) * _e4143)) - _e4221) * _e4145)), _e4152), select(1f, (_e4269 + (((_e4278 + ((_e4287 - _e4278) * _e4143)) - _e4269) * _e4145)), _e4152));
}
let _e4297 = phi_7412_;
local = (_e3952 + _e4141);
let _e4299 = local;
let _e4301 = select(_e3956, _e4299, (_e4299 < _e3956));
let _e4306 = global_6.member[bitcast<u32>(select(0i, _e4301, (_e4301 > 0i)))];
let _e4307 = bitcast<u32>(_e4306);
let _e4311 = f32((bitcast<i32>((_e4307 & 65535u)) - 32768i));
let _e4317 = f32((bitcast<i32>(((_e4307 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4322 = select(_e4317, -(_e4317), ((_e4307 >> bitcast<u32>(31i)) != 0u));
let _e4323 = local;
let _e4324 = (_e4323 + 1i);
let _e4326 = select(_e3956, _e4324, (_e4324 < _e3956));
let _e4331 = global_6.member[bitcast<u32>(select(0i, _e4326, (_e4326 > 0i)))];
let _e4332 = bitcast<u32>(_e4331);
let _e4342 = f32((bitcast<i32>(((_e4332 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4348 = local;
let _e4349 = (_e4348 + _e3890);
let _e4351 = select(_e3956, _e4349, (_e4349 < _e3956));
let _e4356 = global_6.member[bitcast<u32>(select(0i, _e4351, (_e4351 > 0i)))];
let _e4357 = bitcast<u32>(_e4356);
let _e4361 = f32((bitcast<i32>((_e4357 & 65535u)) - 32768i));
let _e4367 = f32((bitcast<i32>(((_e4357 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4372 = select(_e4367, -(_e4367), ((_e4357 >> bitcast<u32>(31i)) != 0u));
let _e4373 = local;
let _e4374 = (_e4373 + _e4030);
let _e4376 = select(_e3956, _e4374, (_e4374 < _e3956));
let _e4381 = global_6.member[bitcast<u32>(select(0i, _e4376, (_e4376 > 0i)))];
let _e4382 = bitcast<u32>(_e4381);
let _e4392 = f32((bitcast<i32>(((_e4382 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4400 = (_e4311 + ((f32((bitcast<i32>((_e4332 & 65535u)) - 32768i)) - _e4311) * _e4143));
let _e4409 = (_e4322 + ((select(_e4342, -(_e4342), ((_e4332 >> bitcast<u32>(31i)) != 0u)) - _e4322) * _e4143));
let _e4422 = global_5.member[_e351].member_9.member_1;
let _e4429 = (_e4080.member + (select(0f, (_e4400 + (((_e4361 + ((f32((bitcast<i32>((_e4382 & 65535u)) - 32768i)) - _e4361) * _e4143)) - _e4400) * _e4145)), _e4152) * _e4083));
let _e4431 = (_e4080.member_1 + (select(0f, (_e4409 + (((_e4372 + ((select(_e4392, -(_e4392), ((_e4382 >> bitcast<u32>(31i)) != 0u)) - _e4372) * _e4143)) - _e4409) * _e4145)), _e4152) * _e4083));
let _e4435 = (1f - ((_e4429 * _e4429) + (_e4431 * _e4431)));
let _e4437 = select(1e-4f, _e4435, (_e4435 > 1e-4f));
phi_7642_ = type_25((_e4297 * vec3<f32>(_e4422.member, _e4422.member_1, _e4422.member_2)), vec3<f32>(_e4429, _e4431, sqrt(select(0f, _e4437, (_e4437 > 0f)))));
}
let _e4444 = phi_7642_;
let _e4453 = (((_e4444.member_1.x * _e4444.member_1.x) + (_e4444.member_1.y * _e4444.member_1.y)) + (_e4444.member_1.z * _e4444.member_1.z));
let _e4456 = sqrt(select(0f, _e4453, (_e4453 > 0f)));
let _e4462 = (1e-6f * _e4456);
let _e4466 = select((_e4456 / select(_e4462, _e4444.member_1.z, (_e4444.member_1.z > _e4462))), 1f, ((_e686 & 8u) != 0u));
let _e4468 = (_e4444.member.x * _e4466);
let _e4470 = (_e4444.member.y * _e4466);
let _e4472 = (_e4444.member.z * _e4466);
if _e802 {
let _e4477 = global_5.member[_e351].member_19;
let _e4486 = (((_e2231.member_1.x * _e2231.member_1.x) + (_e2231.member_1.y * _e2231.member_1.y)) + (_e2231.member_1.z * _e2231.member_1.z));
let _e4489 = sqrt(select(0f, _e4486, (_e4486 > 0f)));
let _e4492 = (1f / select(1e-20f, _e4489, (_e4489 > 1e-20f)));
let _e4493 = (_e2231.member_1.x * _e4492);
let _e4494 = (_e2231.member_1.y * _e4492);
let _e4495 = (_e2231.member_1.z * _e4492);
let _e4498 = (-1f / select(1e-20f, _e4456, (_e4456 > 1e-20f)));
let _e4499 = (_e4444.member_1.x * _e4498);
let _e4500 = (_e4444.member_1.y * _e4498);
let _e4501 = (_e4444.member_1.z * _e4498);
let _e4506 = (((_e355[3] * _e355[3]) + (_e355[4] * _e355[4])) + (_e355[5] * _e355[5]));
let _e4509 = sqrt(select(0f, _e4506, (_e4506 > 0f)));
let _e4512 = (-1f / select(1e-20f, _e4509, (_e4509 > 1e-20f)));
let _e4513 = (_e355[3] * _e4512);
let _e4514 = (_e355[4] * _e4512);
let _e4515 = (_e355[5] * _e4512);
let _e4522 = select(1f, -1f, ((((_e4493 * _e4513) + (_e4494 * _e4514)) + (_e4495 * _e4515)) < 0f));
let _e4523 = (_e4493 * _e4522);
let _e4524 = (_e4494 * _e4522);
let _e4525 = (_e4495 * _e4522);
let _e4530 = (((_e4523 * _e4513) + (_e4524 * _e4514)) + (_e4525 * _e4515));
let _e4532 = select(1e-4f, _e4530, (_e4530 > 1e-4f));
let _e4537 = (((_e4523 * _e4499) + (_e4524 * _e4500)) + (_e4525 * _e4501));
let _e4538 = (_e4499 + _e4513);
let _e4539 = (_e4500 + _e4514);
let _e4540 = (_e4501 + _e4515);
let _e4545 = (((_e4538 * _e4538) + (_e4539 * _e4539)) + (_e4540 * _e4540));
let _e4548 = sqrt(select(0f, _e4545, (_e4545 > 0f)));
let _e4551 = (1f / select(1e-6f, _e4548, (_e4548 > 1e-6f)));
let _e4552 = (_e4538 * _e4551);
let _e4553 = (_e4539 * _e4551);
let _e4554 = (_e4540 * _e4551);
let _e4559 = (((_e4523 * _e4552) + (_e4524 * _e4553)) + (_e4525 * _e4554));
let _e4561 = select(0f, _e4559, (_e4559 > 0f));
let _e4566 = (((_e4513 * _e4552) + (_e4514 * _e4553)) + (_e4515 * _e4554));
let _e4568 = select(0f, _e4566, (_e4566 > 0f));
let _e4569 = (_e4477 * _e4477);
let _e4570 = (_e4569 * _e4569);
let _e4574 = (((_e4561 * _e4561) * (_e4570 - 1f)) + 1f);
let _e4578 = (_e4537 > 0f);
let _e4579 = select(0f, _e4537, _e4578);
let _e4581 = (1f - _e4570);
let _e4583 = (((_e4579 * _e4579) * _e4581) + _e4570);
let _e4590 = (((_e4532 * _e4532) * _e4581) + _e4570);
let _e4595 = ((_e4532 * sqrt(select(0f, _e4583, (_e4583 > 0f)))) + (_e4579 * sqrt(select(0f, _e4590, (_e4590 > 0f)))));
let _e4600 = (_e2231.member_2 / _e2567);
let _e4604 = (((_e4600 * _e4600) - 1f) + (_e4568 * _e4568));
let _e4607 = sqrt(select(0f, _e4604, (_e4604 > 0f)));
let _e4608 = (_e4607 - _e4568);
let _e4609 = (_e4607 + _e4568);
let _e4612 = (_e4608 / select(1e-6f, _e4609, (_e4609 > 1e-6f)));
let _e4616 = ((_e4568 * _e4608) + 1f);
let _e4619 = (((_e4568 * _e4609) - 1f) / select(1e-6f, _e4616, (_e4616 > 1e-6f)));
let _e4637 = global_5.member[_e351].member_20;
let _e4641 = ((select(0f, ((((_e4570 / ((3.1415927f * _e4574) * _e4574)) * (0.5f / select(1e-6f, _e4595, (_e4595 > 1e-6f)))) * select(select((((0.5f * _e4612) * _e4612) * (1f + (_e4619 * _e4619))), 1f, (_e4604 <= 0f)), 0f, (_e2567 == _e2231.member_2))) * _e4579), (_e4578 && (_e4489 > 1e-12f))) * _e4637) * select(_e2783.member_2, 0f, _e443));
phi_7960_ = vec3<f32>((_e4468 * _e4641), (_e4470 * _e4641), (_e4472 * _e4641));
} else {
phi_7960_ = vec3<f32>(0f, 0f, 0f);
}
let _e4647 = phi_7960_;
let _e4651 = global_5.member[_e351].member_18;
let _e4658 = (1f - _e355[12]);
let _e4678 = (_e355[9] + ((_e355[13] * ((_e3816.member_3.x * (_e4468 + _e4651.member)) + _e4647.x)) * _e4658));
let _e4679 = (_e355[10] + ((_e355[14] * ((_e3816.member_3.y * (_e4470 + _e4651.member_1)) + _e4647.y)) * _e4658));
let _e4680 = (_e355[11] + ((_e355[15] * ((_e3816.member_3.z * (_e4472 + _e4651.member_2)) + _e4647.z)) * _e4658));
let _e4683 = (_e355[12] + (_e4658 * _e3816.member_1));
let _e4686 = (_e355[13] * _e3816.member_2.x);
let _e4688 = (_e355[14] * _e3816.member_2.y);
let _e4690 = (_e355[15] * _e3816.member_2.z);
let _e4695 = (_e355[8] + ((_e4683 - _e355[12]) * (_e375 + (_e2872 * 0.5f))));
let _e4704 = (-((((select(_e772.member, _e759.member, _e752) * _e4444.member_1.x) + (select(_e772.member_1, _e759.member_1, _e752) * _e4444.member_1.y)) + (select(_e772.member_2, _e759.member_2, _e752) * _e4444.member_1.z))) / select(1e-20f, _e4456, (_e4456 > 1e-20f)));
let _e4709 = bitcast<f32>((bitcast<u32>(select(0f, _e4704, (_e4704 > 0f))) & 2147483647u));
let _e4719 = (1f - _e4683);
let _e4732 = select(_e4683, 1f, _e443);
if _e802 {
let _e4741 = global_5.member[_e351].member_5.member_4;
let _e4744 = (_e2231.member_3.x * _e2783.member_2);
let _e4746 = (_e2231.member_3.y * _e2783.member_2);
let _e4748 = (_e2231.member_3.z * _e2783.member_2);
let _e4749 = (0.5f * _e370);
let _e4753 = (_e355[3] + (_e4744 * _e4749));
let _e4754 = (_e355[4] + (_e4746 * _e4749));
let _e4755 = (_e355[5] + (_e4748 * _e4749));
let _e4757 = (2f * _e369);
let _e4759 = ((_e4755 * _e4755) + (_e4757 * _e4748));
let _e4763 = (_e4755 + sqrt(select(0f, _e4759, (_e4759 > 0f))));
let _e4767 = (0.5f * (_e4757 / select(1e-6f, _e4763, (_e4763 > 1e-6f))));
let _e4771 = (_e4753 + (_e4744 * _e4767));
let _e4772 = (_e4754 + (_e4746 * _e4767));
let _e4773 = (_e4755 + (_e4748 * _e4767));
let _e4777 = (_e4741 * _e4741);
let _e4779 = (_e4773 * _e4773);
let _e4787 = (((_e4755 <= 0f) || (_e4759 <= 0f)) || ((_e4773 <= 0f) || (_e4779 <= (_e4777 * (((_e4771 * _e4771) + (_e4772 * _e4772)) + _e4779)))));
let _e4801 = (_e355[3] + ((_e2231.member_4.x * _e2783.member_2) * _e369));
let _e4802 = (_e355[4] + ((_e2231.member_4.y * _e2783.member_2) * _e369));
let _e4803 = (_e355[5] + ((_e2231.member_4.z * _e2783.member_2) * _e369));
let _e4805 = (_e4803 * _e4803);
let _e4814 = ((_e686 & 1u) != 0u);
phi_8265_ = vec3<f32>(select(select(_e4771, _e4753, _e4787), _e4801, _e4814), select(select(_e4772, _e4754, _e4787), _e4802, _e4814), select(select(_e4773, _e4755, _e4787), _e4803, _e4814));
phi_8266_ = select(_e4787, ((_e4803 <= 0f) || (_e4805 <= (_e4777 * (((_e4801 * _e4801) + (_e4802 * _e4802)) + _e4805)))), _e4814);
} else {
phi_8265_ = vec3<f32>(_e355[3], _e355[4], _e355[5]);
phi_8266_ = false;
}
let _e4821 = phi_8265_;
let _e4823 = phi_8266_;
let _e4832 = (((_e443 || (_e4821.x != _e355[3])) || (_e4821.y != _e355[4])) || (_e4821.z != _e355[5]));
let _e4834 = select(_e4688, _e4686, (_e4686 > _e4688));
phi_8331_ = array<f32, 18>(select(_e355[0], select(_e383, _e3821, _e443), _e4832), select(_e355[1], select(_e385, _e3822, _e443), _e4832), select(_e355[2], select(_e390, _e3823, _e443), _e4832), _e4821.x, _e4821.y, _e4821.z, _e2231.member, select(select(0f, 2f, _e4823), 1f, (_e443 || (((1f - _e4732) * select(_e4690, _e4834, (_e4834 > _e4690))) < 9.765625e-4f))), select(_e4695, (_e4695 + (_e4719 * _e3823)), _e443), select(_e4678, (_e4678 + ((_e4686 * (select(_e778.member, _e765.member, _e752) * ((_e4468 * _e4709) + _e4651.member))) * _e4719)), _e443), select(_e4679, (_e4679 + ((_e4688 * (select(_e778.member_1, _e765.member_1, _e752) * ((_e4470 * _e4709) + _e4651.member_1))) * _e4719)), _e443), select(_e4680, (_e4680 + ((_e4690 * (select(_e778.member_2, _e765.member_2, _e752) * ((_e4472 * _e4709) + _e4651.member_2))) * _e4719)), _e443), _e4732, _e4686, _e4688, _e4690, _e2231.member_2, _e390);
} else {
phi_8331_ = _e355;
}
let _e4853 = phi_8331_;
phi_582_ = (_e351 + 1u);
phi_585_ = select(_e353, true, _e724);
phi_587_ = _e4853;
} else {
phi_582_ = u32();
phi_585_ = bool();
phi_587_ = array<f32, 18>();
}
let _e4857 = phi_582_;
let _e4859 = phi_585_;
let _e4861 = phi_587_;
continue;
continuing {
phi_581_ = _e4857;
phi_584_ = _e4859;
phi_586_ = _e4861;
phi_8414_ = false;
break if !(_e356);
}
}
let _e4864 = phi_8414_;
if _e4864 {
break;
}
let _e4866 = local_8;
if _e4866 {
let _e4868 = local_9;
global_4.member[_e151] = _e4868[0];
let _e4873 = local_10;
global_4.member[_e163] = _e4873[1];
let _e4878 = local_11;
global_4.member[_e174] = _e4878[2];
let _e4883 = local_12;
global_4.member[_e185] = _e4883[3];
let _e4888 = local_13;
global_4.member[_e196] = _e4888[4];
let _e4893 = local_14;
global_4.member[_e207] = _e4893[5];
let _e4898 = local_15;
global_4.member[_e218] = _e4898[6];
let _e4903 = local_16;
global_4.member[_e229] = _e4903[7];
let _e4908 = local_17;
global_4.member[_e240] = _e4908[8];
let _e4913 = local_18;
global_4.member[_e251] = _e4913[9];
let _e4918 = local_19;
global_4.member[_e262] = _e4918[10];
let _e4923 = local_20;
global_4.member[_e273] = _e4923[11];
let _e4928 = local_21;
global_4.member[_e284] = _e4928[12];
let _e4933 = local_22;
global_4.member[_e295] = _e4933[13];
let _e4938 = local_23;
global_4.member[_e306] = _e4938[14];
let _e4943 = local_24;
global_4.member[_e317] = _e4943[15];
let _e4948 = local_25;
global_4.member[_e328] = _e4948[16];
let _e4953 = local_26;
global_4.member[_e339] = _e4953[17];
}
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
