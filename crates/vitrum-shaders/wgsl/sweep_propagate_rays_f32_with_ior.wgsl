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
@group(0) @binding(2)
var<storage> global_7: type_16;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var local_6: type_28;
var local_7: vec3<f32>;
var local_8: type_28;
var local_9: vec3<f32>;
var local_10: type_28;
var local_11: vec3<f32>;
var phi_588_: u32;
var phi_591_: bool;
var phi_593_: array<f32, 18>;
var phi_5037_: type_29;
var phi_5683_: type_30;
var phi_6759_: f32;
var phi_7148_: type_5;
var phi_8706_: type_31;
var phi_9459_: vec3<f32>;
var phi_9689_: type_25;
var phi_10007_: vec3<f32>;
var phi_10312_: vec3<f32>;
var phi_10313_: bool;
var phi_10378_: array<f32, 18>;
var phi_589_: u32;
var phi_592_: bool;
var phi_594_: array<f32, 18>;
var phi_10461_: bool;
var local_12: bool;
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
var local_27: array<f32, 18>;
var local_28: array<f32, 18>;
var local_29: array<f32, 18>;
var local_30: array<f32, 18>;
switch bitcast<i32>(0u) {
default: {
let _e118 = global;
let _e120 = arrayLength((&global_5.member));
let _e123 = arrayLength((&global_1.member));
let _e126 = arrayLength((&global_7.member));
let _e130 = arrayLength((&global_3.member));
if (0u < _e120) {
} else {
break;
}
let _e140 = global_5.member[0u].member_2;
let _e144 = global_5.member[0u].member;
let _e152 = (_e118.x + _e140.member);
let _e154 = (_e118.y + _e140.member_1);
if (_e152 < _e140.member_2) {
if (_e154 < _e140.member_3) {
let _e157 = (_e144.member * _e144.member_1);
let _e159 = ((_e154 * _e144.member) + _e152);
let _e160 = bitcast<i32>(_e159);
let _e162 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e164 = select(_e162, _e160, (_e160 < _e162));
let _e170 = global_4.member[bitcast<u32>(select(0i, _e164, (_e164 > 0i)))];
let _e171 = (_e157 + _e159);
let _e172 = bitcast<i32>(_e171);
let _e174 = select(_e162, _e172, (_e172 < _e162));
let _e180 = global_4.member[bitcast<u32>(select(0i, _e174, (_e174 > 0i)))];
let _e182 = ((2u * _e157) + _e159);
let _e183 = bitcast<i32>(_e182);
let _e185 = select(_e162, _e183, (_e183 < _e162));
let _e191 = global_4.member[bitcast<u32>(select(0i, _e185, (_e185 > 0i)))];
let _e193 = ((3u * _e157) + _e159);
let _e194 = bitcast<i32>(_e193);
let _e196 = select(_e162, _e194, (_e194 < _e162));
let _e202 = global_4.member[bitcast<u32>(select(0i, _e196, (_e196 > 0i)))];
let _e204 = ((4u * _e157) + _e159);
let _e205 = bitcast<i32>(_e204);
let _e207 = select(_e162, _e205, (_e205 < _e162));
let _e213 = global_4.member[bitcast<u32>(select(0i, _e207, (_e207 > 0i)))];
let _e215 = ((5u * _e157) + _e159);
let _e216 = bitcast<i32>(_e215);
let _e218 = select(_e162, _e216, (_e216 < _e162));
let _e224 = global_4.member[bitcast<u32>(select(0i, _e218, (_e218 > 0i)))];
let _e226 = ((6u * _e157) + _e159);
let _e227 = bitcast<i32>(_e226);
let _e229 = select(_e162, _e227, (_e227 < _e162));
let _e235 = global_4.member[bitcast<u32>(select(0i, _e229, (_e229 > 0i)))];
let _e237 = ((7u * _e157) + _e159);
let _e238 = bitcast<i32>(_e237);
let _e240 = select(_e162, _e238, (_e238 < _e162));
let _e246 = global_4.member[bitcast<u32>(select(0i, _e240, (_e240 > 0i)))];
let _e248 = ((8u * _e157) + _e159);
let _e249 = bitcast<i32>(_e248);
let _e251 = select(_e162, _e249, (_e249 < _e162));
let _e257 = global_4.member[bitcast<u32>(select(0i, _e251, (_e251 > 0i)))];
let _e259 = ((9u * _e157) + _e159);
let _e260 = bitcast<i32>(_e259);
let _e262 = select(_e162, _e260, (_e260 < _e162));
let _e268 = global_4.member[bitcast<u32>(select(0i, _e262, (_e262 > 0i)))];
let _e270 = ((10u * _e157) + _e159);
let _e271 = bitcast<i32>(_e270);
let _e273 = select(_e162, _e271, (_e271 < _e162));
let _e279 = global_4.member[bitcast<u32>(select(0i, _e273, (_e273 > 0i)))];
let _e281 = ((11u * _e157) + _e159);
let _e282 = bitcast<i32>(_e281);
let _e284 = select(_e162, _e282, (_e282 < _e162));
let _e290 = global_4.member[bitcast<u32>(select(0i, _e284, (_e284 > 0i)))];
let _e292 = ((12u * _e157) + _e159);
let _e293 = bitcast<i32>(_e292);
let _e295 = select(_e162, _e293, (_e293 < _e162));
let _e301 = global_4.member[bitcast<u32>(select(0i, _e295, (_e295 > 0i)))];
let _e303 = ((13u * _e157) + _e159);
let _e304 = bitcast<i32>(_e303);
let _e306 = select(_e162, _e304, (_e304 < _e162));
let _e312 = global_4.member[bitcast<u32>(select(0i, _e306, (_e306 > 0i)))];
let _e314 = ((14u * _e157) + _e159);
let _e315 = bitcast<i32>(_e314);
let _e317 = select(_e162, _e315, (_e315 < _e162));
let _e323 = global_4.member[bitcast<u32>(select(0i, _e317, (_e317 > 0i)))];
let _e325 = ((15u * _e157) + _e159);
let _e326 = bitcast<i32>(_e325);
let _e328 = select(_e162, _e326, (_e326 < _e162));
let _e334 = global_4.member[bitcast<u32>(select(0i, _e328, (_e328 > 0i)))];
let _e336 = ((16u * _e157) + _e159);
let _e337 = bitcast<i32>(_e336);
let _e339 = select(_e162, _e337, (_e337 < _e162));
let _e345 = global_4.member[bitcast<u32>(select(0i, _e339, (_e339 > 0i)))];
let _e347 = ((17u * _e157) + _e159);
let _e348 = bitcast<i32>(_e347);
let _e350 = select(_e162, _e348, (_e348 < _e162));
let _e356 = global_4.member[bitcast<u32>(select(0i, _e350, (_e350 > 0i)))];
phi_588_ = 0u;
phi_591_ = false;
phi_593_ = array<f32, 18>(_e170, _e180, _e191, _e202, _e213, _e224, _e235, _e246, _e257, _e268, _e279, _e290, _e301, _e312, _e323, _e334, _e345, _e356);
loop {
let _e359 = phi_588_;
let _e361 = phi_591_;
let _e363 = phi_593_;
local_12 = _e361;
local_13 = _e363;
local_14 = _e363;
local_15 = _e363;
local_16 = _e363;
local_17 = _e363;
local_18 = _e363;
local_19 = _e363;
local_20 = _e363;
local_21 = _e363;
local_22 = _e363;
local_23 = _e363;
local_24 = _e363;
local_25 = _e363;
local_26 = _e363;
local_27 = _e363;
local_28 = _e363;
local_29 = _e363;
local_30 = _e363;
let _e364 = (_e359 < _e120);
if _e364 {
if _e364 {
} else {
phi_10461_ = true;
break;
}
let _e377 = global_5.member[_e359].member_5.member_2;
let _e378 = (_e377 / _e363[5]);
let _e383 = global_5.member[_e359].member_5.member;
let _e385 = ((_e383 - _e363[2]) / _e363[5]);
let _e387 = (_e363[0] + (_e363[3] * _e385));
let _e389 = (_e363[1] + (_e363[4] * _e385));
let _e391 = (_e387 + (_e363[3] * _e378));
let _e393 = (_e389 + (_e363[4] * _e378));
let _e398 = global_5.member[_e359].member_5.member_1;
let _e404 = global_5.member[_e359].member_13.member.member;
let _e415 = ((((_e404.member.member * _e387) + (_e404.member.member_1 * _e389)) + (_e404.member.member_2 * _e383)) + _e404.member_1);
let _e421 = ((((_e404.member.member * _e391) + (_e404.member.member_1 * _e393)) + (_e404.member.member_2 * _e398)) + _e404.member_1);
let _e424 = ((_e415 > 0f) && (_e421 <= 0f));
let _e430 = global_5.member[_e359].member_13.member_1.member;
let _e441 = ((((_e430.member.member * _e387) + (_e430.member.member_1 * _e389)) + (_e430.member.member_2 * _e383)) + _e430.member_1);
let _e447 = ((((_e430.member.member * _e391) + (_e430.member.member_1 * _e393)) + (_e430.member.member_2 * _e398)) + _e430.member_1);
let _e450 = ((_e441 > 0f) && (_e447 <= 0f));
let _e451 = (_e424 || _e450);
let _e456 = global_5.member[_e359].member_6.member;
let _e467 = ((((_e456.member.member * _e387) + (_e456.member.member_1 * _e389)) + (_e456.member.member_2 * _e383)) + _e456.member_1);
let _e472 = global_5.member[_e359].member_6.member_1;
let _e483 = ((((_e472.member.member * _e387) + (_e472.member.member_1 * _e389)) + (_e472.member.member_2 * _e383)) + _e472.member_1);
let _e488 = global_5.member[_e359].member_6.member_2;
let _e499 = ((((_e488.member.member * _e387) + (_e488.member.member_1 * _e389)) + (_e488.member.member_2 * _e383)) + _e488.member_1);
let _e505 = ((((_e456.member.member * _e391) + (_e456.member.member_1 * _e393)) + (_e456.member.member_2 * _e398)) + _e456.member_1);
let _e511 = ((((_e472.member.member * _e391) + (_e472.member.member_1 * _e393)) + (_e472.member.member_2 * _e398)) + _e472.member_1);
let _e517 = ((((_e488.member.member * _e391) + (_e488.member.member_1 * _e393)) + (_e488.member.member_2 * _e398)) + _e488.member_1);
let _e522 = global_5.member[_e359].member_6.member_4;
let _e528 = global_5.member[_e359].member_6.member_3.member;
let _e529 = (_e528 - 0.5f);
let _e531 = select(-0.5f, _e505, (_e505 > -0.5f));
let _e533 = select(_e529, _e531, (_e531 < _e529));
let _e539 = global_5.member[_e359].member_6.member_3.member_1;
let _e540 = (_e539 - 0.5f);
let _e542 = select(-0.5f, _e511, (_e511 > -0.5f));
let _e544 = select(_e540, _e542, (_e542 < _e540));
let _e550 = global_5.member[_e359].member_6.member_3.member_2;
let _e551 = (_e550 - 0.5f);
let _e553 = select(-0.5f, _e517, (_e517 > -0.5f));
let _e555 = select(_e551, _e553, (_e553 < _e551));
let _e556 = (_e505 - _e467);
let _e557 = (_e511 - _e483);
let _e558 = (_e517 - _e499);
let _e561 = bitcast<f32>((bitcast<u32>(_e556) & 2147483647u));
let _e564 = bitcast<f32>((bitcast<u32>(_e557) & 2147483647u));
let _e566 = select(_e564, _e561, (_e561 > _e564));
let _e569 = bitcast<f32>((bitcast<u32>(_e558) & 2147483647u));
let _e578 = bitcast<f32>((bitcast<u32>((_e505 - _e533)) & 2147483647u));
let _e581 = bitcast<f32>((bitcast<u32>((_e511 - _e544)) & 2147483647u));
let _e583 = select(_e581, _e578, (_e578 > _e581));
let _e586 = bitcast<f32>((bitcast<u32>((_e517 - _e555)) & 2147483647u));
let _e590 = (_e533 + 0.5f);
let _e591 = (_e528 - 1f);
let _e593 = select(0f, _e590, (_e590 > 0f));
let _e595 = select(_e591, _e593, (_e593 < _e591));
let _e602 = select(0i, select(select(i32(_e595), i32(-2147483648), (_e595 < -2147483600f)), 2147483647i, (_e595 > 2147483500f)), (_e595 == _e595));
let _e611 = global_5.member[_e359].member_6.member_12;
let _e612 = (_e611 & 31u);
let _e615 = (_e544 + 0.5f);
let _e616 = (_e539 - 1f);
let _e618 = select(0f, _e615, (_e615 > 0f));
let _e620 = select(_e616, _e618, (_e618 < _e616));
let _e627 = select(0i, select(select(i32(_e620), i32(-2147483648), (_e620 < -2147483600f)), 2147483647i, (_e620 > 2147483500f)), (_e620 == _e620));
let _e634 = (_e555 + 0.5f);
let _e635 = (_e550 - 1f);
let _e637 = select(0f, _e634, (_e634 > 0f));
let _e639 = select(_e635, _e637, (_e637 < _e635));
let _e646 = select(0i, select(select(i32(_e639), i32(-2147483648), (_e639 < -2147483600f)), 2147483647i, (_e639 > 2147483500f)), (_e639 == _e639));
let _e658 = global_5.member[_e359].member_6.member_9.member;
let _e665 = global_5.member[_e359].member_6.member_9.member_1;
let _e671 = global_5.member[_e359].member_6.member_10;
let _e677 = ((bitcast<i32>(_e671) + ((_e602 - select(0i, 1i, (_e595 < f32(_e602)))) >> bitcast<u32>(_e612))) + (bitcast<i32>(_e658) * (((_e627 - select(0i, 1i, (_e620 < f32(_e627)))) >> bitcast<u32>(_e612)) + (bitcast<i32>(_e665) * ((_e646 - select(0i, 1i, (_e639 < f32(_e646)))) >> bitcast<u32>(_e612))))));
let _e679 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e681 = select(_e679, _e677, (_e677 < _e679));
let _e687 = global_2.member[bitcast<u32>(select(0i, _e681, (_e681 > 0i)))];
let _e695 = global_5.member[_e359].member_7.member;
let _e706 = ((((_e695.member.member * _e387) + (_e695.member.member_1 * _e389)) + (_e695.member.member_2 * _e383)) + _e695.member_1);
let _e711 = global_5.member[_e359].member_7.member_1;
let _e722 = ((((_e711.member.member * _e387) + (_e711.member.member_1 * _e389)) + (_e711.member.member_2 * _e383)) + _e711.member_1);
let _e727 = global_5.member[_e359].member_7.member_2;
let _e738 = ((((_e727.member.member * _e387) + (_e727.member.member_1 * _e389)) + (_e727.member.member_2 * _e383)) + _e727.member_1);
let _e744 = ((((_e695.member.member * _e391) + (_e695.member.member_1 * _e393)) + (_e695.member.member_2 * _e398)) + _e695.member_1);
let _e750 = ((((_e711.member.member * _e391) + (_e711.member.member_1 * _e393)) + (_e711.member.member_2 * _e398)) + _e711.member_1);
let _e756 = ((((_e727.member.member * _e391) + (_e727.member.member_1 * _e393)) + (_e727.member.member_2 * _e398)) + _e727.member_1);
let _e761 = global_5.member[_e359].member_7.member_4;
let _e767 = global_5.member[_e359].member_7.member_3.member;
let _e768 = (_e767 - 0.5f);
let _e770 = select(-0.5f, _e744, (_e744 > -0.5f));
let _e772 = select(_e768, _e770, (_e770 < _e768));
let _e778 = global_5.member[_e359].member_7.member_3.member_1;
let _e779 = (_e778 - 0.5f);
let _e781 = select(-0.5f, _e750, (_e750 > -0.5f));
let _e783 = select(_e779, _e781, (_e781 < _e779));
let _e789 = global_5.member[_e359].member_7.member_3.member_2;
let _e790 = (_e789 - 0.5f);
let _e792 = select(-0.5f, _e756, (_e756 > -0.5f));
let _e794 = select(_e790, _e792, (_e792 < _e790));
let _e800 = bitcast<f32>((bitcast<u32>((_e744 - _e706)) & 2147483647u));
let _e803 = bitcast<f32>((bitcast<u32>((_e750 - _e722)) & 2147483647u));
let _e805 = select(_e803, _e800, (_e800 > _e803));
let _e808 = bitcast<f32>((bitcast<u32>((_e756 - _e738)) & 2147483647u));
let _e817 = bitcast<f32>((bitcast<u32>((_e744 - _e772)) & 2147483647u));
let _e820 = bitcast<f32>((bitcast<u32>((_e750 - _e783)) & 2147483647u));
let _e822 = select(_e820, _e817, (_e817 > _e820));
let _e825 = bitcast<f32>((bitcast<u32>((_e756 - _e794)) & 2147483647u));
let _e829 = (_e772 + 0.5f);
let _e830 = (_e767 - 1f);
let _e832 = select(0f, _e829, (_e829 > 0f));
let _e834 = select(_e830, _e832, (_e832 < _e830));
let _e841 = select(0i, select(select(i32(_e834), i32(-2147483648), (_e834 < -2147483600f)), 2147483647i, (_e834 > 2147483500f)), (_e834 == _e834));
let _e850 = global_5.member[_e359].member_7.member_12;
let _e851 = (_e850 & 31u);
let _e854 = (_e783 + 0.5f);
let _e855 = (_e778 - 1f);
let _e857 = select(0f, _e854, (_e854 > 0f));
let _e859 = select(_e855, _e857, (_e857 < _e855));
let _e866 = select(0i, select(select(i32(_e859), i32(-2147483648), (_e859 < -2147483600f)), 2147483647i, (_e859 > 2147483500f)), (_e859 == _e859));
let _e873 = (_e794 + 0.5f);
let _e874 = (_e789 - 1f);
let _e876 = select(0f, _e873, (_e873 > 0f));
let _e878 = select(_e874, _e876, (_e876 < _e874));
let _e885 = select(0i, select(select(i32(_e878), i32(-2147483648), (_e878 < -2147483600f)), 2147483647i, (_e878 > 2147483500f)), (_e878 == _e878));
let _e897 = global_5.member[_e359].member_7.member_9.member;
let _e904 = global_5.member[_e359].member_7.member_9.member_1;
let _e910 = global_5.member[_e359].member_7.member_10;
let _e916 = ((bitcast<i32>(_e910) + ((_e841 - select(0i, 1i, (_e834 < f32(_e841)))) >> bitcast<u32>(_e851))) + (bitcast<i32>(_e897) * (((_e866 - select(0i, 1i, (_e859 < f32(_e866)))) >> bitcast<u32>(_e851)) + (bitcast<i32>(_e904) * ((_e885 - select(0i, 1i, (_e878 < f32(_e885)))) >> bitcast<u32>(_e851))))));
let _e918 = select(_e679, _e916, (_e916 < _e679));
let _e924 = global_2.member[bitcast<u32>(select(0i, _e918, (_e918 > 0i)))];
let _e931 = global_5.member[_e359].member_1;
let _e963 = (_e363[17] != _e383);
let _e969 = (select(0u, select(select(select(select(7u, 3u, (((((((_e467 >= 0f) && (_e467 <= _e591)) && (_e483 >= 0f)) && (_e483 <= _e616)) && (_e499 >= 0f)) && (_e499 <= _e635)) && ((((((_e505 >= 0f) && (_e505 <= _e591)) && (_e511 >= 0f)) && (_e511 <= _e616)) && (_e517 >= 0f)) && (_e517 <= _e635)))), 15u, _e963), 1u, (((_e931 & 64u) != 0u) || ((((select(_e569, _e566, (_e566 > _e569)) <= _e522) && ((select(_e586, _e583, (_e583 > _e586)) > _e522) || (_e687 != 0u))) && ((select(_e808, _e805, (_e805 > _e808)) <= _e761) && ((select(_e825, _e822, (_e822 > _e825)) > _e761) || (_e924 != 0u)))) && ((_e931 & 32u) != 0u)))), 31u, _e451), (_e363[7] == 0f)) > 1u);
if _e969 {
let _e973 = global_5.member[_e359].member;
let _e986 = (_e415 - _e421);
let _e989 = (_e415 / select(1e-20f, _e986, (_e986 > 1e-20f)));
let _e990 = (_e441 - _e447);
let _e993 = (_e441 / select(1e-20f, _e990, (_e990 > 1e-20f)));
let _e997 = (_e450 && (!(_e424) || (_e993 < _e989)));
let _e1004 = global_5.member[_e359].member_13.member_1.member.member;
let _e1010 = global_5.member[_e359].member_13.member_1.member_1;
let _e1017 = global_5.member[_e359].member_13.member.member.member;
let _e1023 = global_5.member[_e359].member_13.member.member_1;
let _e1042 = select(_e989, _e993, _e997);
let _e1044 = (_e973.member_2 == 2u);
let _e1047 = (((_e973.member_2 == 1u) || _e1044) || (_e973.member_2 == 5u));
if _e1047 {
let _e1049 = select(-1f, _e533, (_e533 > -1f));
let _e1051 = select(_e528, _e1049, (_e1049 < _e528));
let _e1058 = select(0i, select(select(i32(_e1051), i32(-2147483648), (_e1051 < -2147483600f)), 2147483647i, (_e1051 > 2147483500f)), (_e1051 == _e1051));
let _e1062 = (_e1058 - select(0i, 1i, (_e1051 < f32(_e1058))));
let _e1064 = select(-1f, _e544, (_e544 > -1f));
let _e1066 = select(_e539, _e1064, (_e1064 < _e539));
let _e1073 = select(0i, select(select(i32(_e1066), i32(-2147483648), (_e1066 < -2147483600f)), 2147483647i, (_e1066 > 2147483500f)), (_e1066 == _e1066));
let _e1077 = (_e1073 - select(0i, 1i, (_e1066 < f32(_e1073))));
let _e1079 = select(-1f, _e555, (_e555 > -1f));
let _e1081 = select(_e550, _e1079, (_e1079 < _e550));
let _e1088 = select(0i, select(select(i32(_e1081), i32(-2147483648), (_e1081 < -2147483600f)), 2147483647i, (_e1081 > 2147483500f)), (_e1081 == _e1081));
let _e1092 = (_e1088 - select(0i, 1i, (_e1081 < f32(_e1088))));
let _e1097 = global_5.member[_e359].member_6.member_7;
let _e1102 = global_5.member[_e359].member_6.member_8;
let _e1110 = (select(0i, select(select(i32(_e539), i32(-2147483648), (_e539 < -2147483600f)), 2147483647i, (_e539 > 2147483500f)), (_e539 == _e539)) - 1i);
let _e1113 = (_e1077 + 1i);
let _e1123 = (select(0i, select(select(i32(_e550), i32(-2147483648), (_e550 < -2147483600f)), 2147483647i, (_e550 > 2147483500f)), (_e550 == _e550)) - 1i);
let _e1126 = (_e1092 + 1i);
let _e1136 = (select(0i, select(select(i32(_e528), i32(-2147483648), (_e528 < -2147483600f)), 2147483647i, (_e528 > 2147483500f)), (_e528 == _e528)) - 1i);
let _e1137 = (_e1062 - 1i);
let _e1142 = (_e1062 + 1i);
let _e1145 = (_e1062 + 2i);
let _e1148 = (select(0i, _e1077, (_e1077 > 0i)) * _e1097);
let _e1149 = (select(_e1110, _e1113, (_e1113 < _e1110)) * _e1097);
let _e1150 = (select(0i, _e1092, (_e1092 > 0i)) * _e1102);
let _e1151 = (select(_e1123, _e1126, (_e1126 < _e1123)) * _e1102);
local_10 = type_28(array<i32, 4>(select(0i, _e1137, (_e1137 > 0i)), select(0i, _e1062, (_e1062 > 0i)), select(_e1136, _e1142, (_e1142 < _e1136)), select(_e1136, _e1145, (_e1145 < _e1136))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_11 = vec3<f32>((_e533 - f32(_e1062)), (_e544 - f32(_e1077)), (_e555 - f32(_e1092)));
let _e1162 = (_e1150 + _e1148);
let _e1164 = (bitcast<i32>(_e123) - 1i);
let _e1167 = local_10.member[1u];
let _e1168 = (_e1162 + _e1167);
let _e1170 = select(_e1164, _e1168, (_e1168 < _e1164));
let _e1175 = global_1.member[bitcast<u32>(select(0i, _e1170, (_e1170 > 0i)))];
let _e1176 = bitcast<f32>(_e1175);
let _e1179 = local_10.member[2u];
let _e1180 = (_e1162 + _e1179);
let _e1182 = select(_e1164, _e1180, (_e1180 < _e1164));
let _e1187 = global_1.member[bitcast<u32>(select(0i, _e1182, (_e1182 > 0i)))];
let _e1189 = local_11[0u];
let _e1192 = (_e1176 + ((bitcast<f32>(_e1187) - _e1176) * _e1189));
let _e1193 = (_e1150 + _e1149);
let _e1194 = local_10.member[1u];
let _e1195 = (_e1193 + _e1194);
let _e1197 = select(_e1164, _e1195, (_e1195 < _e1164));
let _e1202 = global_1.member[bitcast<u32>(select(0i, _e1197, (_e1197 > 0i)))];
let _e1203 = bitcast<f32>(_e1202);
let _e1204 = local_10.member[2u];
let _e1205 = (_e1193 + _e1204);
let _e1207 = select(_e1164, _e1205, (_e1205 < _e1164));
let _e1212 = global_1.member[bitcast<u32>(select(0i, _e1207, (_e1207 > 0i)))];
let _e1214 = local_11[0u];
let _e1218 = (_e1151 + _e1148);
let _e1219 = local_10.member[1u];
let _e1220 = (_e1218 + _e1219);
let _e1222 = select(_e1164, _e1220, (_e1220 < _e1164));
let _e1227 = global_1.member[bitcast<u32>(select(0i, _e1222, (_e1222 > 0i)))];
let _e1228 = bitcast<f32>(_e1227);
let _e1229 = local_10.member[2u];
let _e1230 = (_e1218 + _e1229);
let _e1232 = select(_e1164, _e1230, (_e1230 < _e1164));
let _e1237 = global_1.member[bitcast<u32>(select(0i, _e1232, (_e1232 > 0i)))];
let _e1239 = local_11[0u];
let _e1242 = (_e1228 + ((bitcast<f32>(_e1237) - _e1228) * _e1239));
let _e1243 = (_e1151 + _e1149);
let _e1244 = local_10.member[1u];
let _e1245 = (_e1243 + _e1244);
let _e1247 = select(_e1164, _e1245, (_e1245 < _e1164));
let _e1252 = global_1.member[bitcast<u32>(select(0i, _e1247, (_e1247 > 0i)))];
let _e1253 = bitcast<f32>(_e1252);
let _e1254 = local_10.member[2u];
let _e1255 = (_e1243 + _e1254);
let _e1257 = select(_e1164, _e1255, (_e1255 < _e1164));
let _e1262 = global_1.member[bitcast<u32>(select(0i, _e1257, (_e1257 > 0i)))];
let _e1264 = local_11[0u];
let _e1269 = local_11[1u];
let _e1272 = (_e1192 + (((_e1203 + ((bitcast<f32>(_e1212) - _e1203) * _e1214)) - _e1192) * _e1269));
let _e1273 = local_11[1u];
let _e1278 = local_11[2u];
let _e1286 = global_5.member[_e359].member_6.member_5;
let _e1292 = global_5.member[_e359].member_6.member_6;
let _e1293 = (((_e1272 + (((_e1242 + (((_e1253 + ((bitcast<f32>(_e1262) - _e1253) * _e1264)) - _e1242) * _e1273)) - _e1272) * _e1278)) * _e1286) + _e1292);
let _e1295 = select(0f, _e1293, (_e1293 > 0f));
let _e1299 = select(-1f, _e772, (_e772 > -1f));
let _e1301 = select(_e767, _e1299, (_e1299 < _e767));
let _e1308 = select(0i, select(select(i32(_e1301), i32(-2147483648), (_e1301 < -2147483600f)), 2147483647i, (_e1301 > 2147483500f)), (_e1301 == _e1301));
let _e1312 = (_e1308 - select(0i, 1i, (_e1301 < f32(_e1308))));
let _e1314 = select(-1f, _e783, (_e783 > -1f));
let _e1316 = select(_e778, _e1314, (_e1314 < _e778));
let _e1323 = select(0i, select(select(i32(_e1316), i32(-2147483648), (_e1316 < -2147483600f)), 2147483647i, (_e1316 > 2147483500f)), (_e1316 == _e1316));
let _e1327 = (_e1323 - select(0i, 1i, (_e1316 < f32(_e1323))));
let _e1329 = select(-1f, _e794, (_e794 > -1f));
let _e1331 = select(_e789, _e1329, (_e1329 < _e789));
let _e1338 = select(0i, select(select(i32(_e1331), i32(-2147483648), (_e1331 < -2147483600f)), 2147483647i, (_e1331 > 2147483500f)), (_e1331 == _e1331));
let _e1342 = (_e1338 - select(0i, 1i, (_e1331 < f32(_e1338))));
let _e1347 = global_5.member[_e359].member_7.member_7;
let _e1352 = global_5.member[_e359].member_7.member_8;
let _e1360 = (select(0i, select(select(i32(_e778), i32(-2147483648), (_e778 < -2147483600f)), 2147483647i, (_e778 > 2147483500f)), (_e778 == _e778)) - 1i);
let _e1361 = (_e1327 - 1i);
let _e1366 = (_e1327 + 1i);
let _e1369 = (_e1327 + 2i);
let _e1379 = (select(0i, select(select(i32(_e789), i32(-2147483648), (_e789 < -2147483600f)), 2147483647i, (_e789 > 2147483500f)), (_e789 == _e789)) - 1i);
let _e1380 = (_e1342 - 1i);
let _e1385 = (_e1342 + 1i);
let _e1388 = (_e1342 + 2i);
let _e1398 = (select(0i, select(select(i32(_e767), i32(-2147483648), (_e767 < -2147483600f)), 2147483647i, (_e767 > 2147483500f)), (_e767 == _e767)) - 1i);
let _e1399 = (_e1312 - 1i);
let _e1404 = (_e1312 + 1i);
let _e1407 = (_e1312 + 2i);
let _e1410 = (select(0i, _e1361, (_e1361 > 0i)) * _e1347);
let _e1411 = (select(0i, _e1327, (_e1327 > 0i)) * _e1347);
let _e1412 = (select(_e1360, _e1366, (_e1366 < _e1360)) * _e1347);
let _e1413 = (select(_e1360, _e1369, (_e1369 < _e1360)) * _e1347);
let _e1414 = (select(0i, _e1380, (_e1380 > 0i)) * _e1352);
let _e1415 = (select(0i, _e1342, (_e1342 > 0i)) * _e1352);
let _e1416 = (select(_e1379, _e1385, (_e1385 < _e1379)) * _e1352);
let _e1417 = (select(_e1379, _e1388, (_e1388 < _e1379)) * _e1352);
local_8 = type_28(array<i32, 4>(select(0i, _e1399, (_e1399 > 0i)), select(0i, _e1312, (_e1312 > 0i)), select(_e1398, _e1404, (_e1404 < _e1398)), select(_e1398, _e1407, (_e1407 < _e1398))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_9 = vec3<f32>((_e772 - f32(_e1312)), (_e783 - f32(_e1327)), (_e794 - f32(_e1342)));
let _e1428 = (_e1415 + _e1411);
let _e1431 = local_8.member[0u];
let _e1432 = (_e1428 + _e1431);
let _e1434 = (bitcast<i32>(_e126) - 1i);
let _e1436 = select(_e1434, _e1432, (_e1432 < _e1434));
let _e1441 = global_7.member[bitcast<u32>(select(0i, _e1436, (_e1436 > 0i)))];
let _e1442 = bitcast<f32>(_e1441);
let _e1445 = local_8.member[1u];
let _e1446 = (_e1428 + _e1445);
let _e1448 = select(_e1434, _e1446, (_e1446 < _e1434));
let _e1453 = global_7.member[bitcast<u32>(select(0i, _e1448, (_e1448 > 0i)))];
let _e1454 = bitcast<f32>(_e1453);
let _e1457 = local_8.member[2u];
let _e1458 = (_e1428 + _e1457);
let _e1460 = select(_e1434, _e1458, (_e1458 < _e1434));
let _e1465 = global_7.member[bitcast<u32>(select(0i, _e1460, (_e1460 > 0i)))];
let _e1466 = bitcast<f32>(_e1465);
let _e1469 = local_8.member[3u];
let _e1470 = (_e1428 + _e1469);
let _e1472 = select(_e1434, _e1470, (_e1470 < _e1434));
let _e1477 = global_7.member[bitcast<u32>(select(0i, _e1472, (_e1472 > 0i)))];
let _e1479 = local_9[0u];
let _e1482 = (_e1442 + ((_e1454 - _e1442) * _e1479));
let _e1483 = local_9[0u];
let _e1486 = (_e1454 + ((_e1466 - _e1454) * _e1483));
let _e1487 = local_9[0u];
let _e1490 = (_e1466 + ((bitcast<f32>(_e1477) - _e1466) * _e1487));
let _e1491 = (_e1415 + _e1412);
let _e1492 = local_8.member[0u];
let _e1493 = (_e1491 + _e1492);
let _e1495 = select(_e1434, _e1493, (_e1493 < _e1434));
let _e1500 = global_7.member[bitcast<u32>(select(0i, _e1495, (_e1495 > 0i)))];
let _e1501 = bitcast<f32>(_e1500);
let _e1502 = local_8.member[1u];
let _e1503 = (_e1491 + _e1502);
let _e1505 = select(_e1434, _e1503, (_e1503 < _e1434));
let _e1510 = global_7.member[bitcast<u32>(select(0i, _e1505, (_e1505 > 0i)))];
let _e1511 = bitcast<f32>(_e1510);
let _e1512 = local_8.member[2u];
let _e1513 = (_e1491 + _e1512);
let _e1515 = select(_e1434, _e1513, (_e1513 < _e1434));
let _e1520 = global_7.member[bitcast<u32>(select(0i, _e1515, (_e1515 > 0i)))];
let _e1521 = bitcast<f32>(_e1520);
let _e1522 = local_8.member[3u];
let _e1523 = (_e1491 + _e1522);
let _e1525 = select(_e1434, _e1523, (_e1523 < _e1434));
let _e1530 = global_7.member[bitcast<u32>(select(0i, _e1525, (_e1525 > 0i)))];
let _e1532 = local_9[0u];
let _e1536 = local_9[0u];
let _e1539 = (_e1511 + ((_e1521 - _e1511) * _e1536));
let _e1540 = local_9[0u];
let _e1544 = (_e1416 + _e1411);
let _e1545 = local_8.member[0u];
let _e1546 = (_e1544 + _e1545);
let _e1548 = select(_e1434, _e1546, (_e1546 < _e1434));
let _e1553 = global_7.member[bitcast<u32>(select(0i, _e1548, (_e1548 > 0i)))];
let _e1554 = bitcast<f32>(_e1553);
let _e1555 = local_8.member[1u];
let _e1556 = (_e1544 + _e1555);
let _e1558 = select(_e1434, _e1556, (_e1556 < _e1434));
let _e1563 = global_7.member[bitcast<u32>(select(0i, _e1558, (_e1558 > 0i)))];
let _e1564 = bitcast<f32>(_e1563);
let _e1565 = local_8.member[2u];
let _e1566 = (_e1544 + _e1565);
let _e1568 = select(_e1434, _e1566, (_e1566 < _e1434));
let _e1573 = global_7.member[bitcast<u32>(select(0i, _e1568, (_e1568 > 0i)))];
let _e1574 = bitcast<f32>(_e1573);
let _e1575 = local_8.member[3u];
let _e1576 = (_e1544 + _e1575);
let _e1578 = select(_e1434, _e1576, (_e1576 < _e1434));
let _e1583 = global_7.member[bitcast<u32>(select(0i, _e1578, (_e1578 > 0i)))];
let _e1585 = local_9[0u];
let _e1588 = (_e1554 + ((_e1564 - _e1554) * _e1585));
let _e1589 = local_9[0u];
let _e1592 = (_e1564 + ((_e1574 - _e1564) * _e1589));
let _e1593 = local_9[0u];
let _e1596 = (_e1574 + ((bitcast<f32>(_e1583) - _e1574) * _e1593));
let _e1597 = (_e1416 + _e1412);
let _e1598 = local_8.member[0u];
let _e1599 = (_e1597 + _e1598);
let _e1601 = select(_e1434, _e1599, (_e1599 < _e1434));
let _e1606 = global_7.member[bitcast<u32>(select(0i, _e1601, (_e1601 > 0i)))];
let _e1607 = bitcast<f32>(_e1606);
let _e1608 = local_8.member[1u];
let _e1609 = (_e1597 + _e1608);
let _e1611 = select(_e1434, _e1609, (_e1609 < _e1434));
let _e1616 = global_7.member[bitcast<u32>(select(0i, _e1611, (_e1611 > 0i)))];
let _e1617 = bitcast<f32>(_e1616);
let _e1618 = local_8.member[2u];
let _e1619 = (_e1597 + _e1618);
let _e1621 = select(_e1434, _e1619, (_e1619 < _e1434));
let _e1626 = global_7.member[bitcast<u32>(select(0i, _e1621, (_e1621 > 0i)))];
let _e1627 = bitcast<f32>(_e1626);
let _e1628 = local_8.member[3u];
let _e1629 = (_e1597 + _e1628);
let _e1631 = select(_e1434, _e1629, (_e1629 < _e1434));
let _e1636 = global_7.member[bitcast<u32>(select(0i, _e1631, (_e1631 > 0i)))];
let _e1638 = local_9[0u];
let _e1642 = local_9[0u];
let _e1645 = (_e1617 + ((_e1627 - _e1617) * _e1642));
let _e1646 = local_9[0u];
let _e1650 = (_e1415 + _e1410);
let _e1651 = local_8.member[1u];
let _e1652 = (_e1650 + _e1651);
let _e1654 = select(_e1434, _e1652, (_e1652 < _e1434));
let _e1659 = global_7.member[bitcast<u32>(select(0i, _e1654, (_e1654 > 0i)))];
let _e1660 = bitcast<f32>(_e1659);
let _e1661 = local_8.member[2u];
let _e1662 = (_e1650 + _e1661);
let _e1664 = select(_e1434, _e1662, (_e1662 < _e1434));
let _e1669 = global_7.member[bitcast<u32>(select(0i, _e1664, (_e1664 > 0i)))];
let _e1671 = local_9[0u];
let _e1674 = (_e1660 + ((bitcast<f32>(_e1669) - _e1660) * _e1671));
let _e1675 = (_e1415 + _e1413);
let _e1676 = local_8.member[1u];
let _e1677 = (_e1675 + _e1676);
let _e1679 = select(_e1434, _e1677, (_e1677 < _e1434));
let _e1684 = global_7.member[bitcast<u32>(select(0i, _e1679, (_e1679 > 0i)))];
let _e1685 = bitcast<f32>(_e1684);
let _e1686 = local_8.member[2u];
let _e1687 = (_e1675 + _e1686);
let _e1689 = select(_e1434, _e1687, (_e1687 < _e1434));
let _e1694 = global_7.member[bitcast<u32>(select(0i, _e1689, (_e1689 > 0i)))];
let _e1696 = local_9[0u];
let _e1700 = (_e1416 + _e1410);
let _e1701 = local_8.member[1u];
let _e1702 = (_e1700 + _e1701);
let _e1704 = select(_e1434, _e1702, (_e1702 < _e1434));
let _e1709 = global_7.member[bitcast<u32>(select(0i, _e1704, (_e1704 > 0i)))];
let _e1710 = bitcast<f32>(_e1709);
let _e1711 = local_8.member[2u];
let _e1712 = (_e1700 + _e1711);
let _e1714 = select(_e1434, _e1712, (_e1712 < _e1434));
let _e1719 = global_7.member[bitcast<u32>(select(0i, _e1714, (_e1714 > 0i)))];
let _e1721 = local_9[0u];
let _e1724 = (_e1710 + ((bitcast<f32>(_e1719) - _e1710) * _e1721));
let _e1725 = (_e1416 + _e1413);
let _e1726 = local_8.member[1u];
let _e1727 = (_e1725 + _e1726);
let _e1729 = select(_e1434, _e1727, (_e1727 < _e1434));
let _e1734 = global_7.member[bitcast<u32>(select(0i, _e1729, (_e1729 > 0i)))];
let _e1735 = bitcast<f32>(_e1734);
let _e1736 = local_8.member[2u];
let _e1737 = (_e1725 + _e1736);
let _e1739 = select(_e1434, _e1737, (_e1737 < _e1434));
let _e1744 = global_7.member[bitcast<u32>(select(0i, _e1739, (_e1739 > 0i)))];
let _e1746 = local_9[0u];
let _e1750 = (_e1414 + _e1411);
let _e1751 = local_8.member[1u];
let _e1752 = (_e1750 + _e1751);
let _e1754 = select(_e1434, _e1752, (_e1752 < _e1434));
let _e1759 = global_7.member[bitcast<u32>(select(0i, _e1754, (_e1754 > 0i)))];
let _e1760 = bitcast<f32>(_e1759);
let _e1761 = local_8.member[2u];
let _e1762 = (_e1750 + _e1761);
let _e1764 = select(_e1434, _e1762, (_e1762 < _e1434));
let _e1769 = global_7.member[bitcast<u32>(select(0i, _e1764, (_e1764 > 0i)))];
let _e1771 = local_9[0u];
let _e1774 = (_e1760 + ((bitcast<f32>(_e1769) - _e1760) * _e1771));
let _e1775 = (_e1417 + _e1411);
let _e1776 = local_8.member[1u];
let _e1777 = (_e1775 + _e1776);
let _e1779 = select(_e1434, _e1777, (_e1777 < _e1434));
let _e1784 = global_7.member[bitcast<u32>(select(0i, _e1779, (_e1779 > 0i)))];
let _e1785 = bitcast<f32>(_e1784);
let _e1786 = local_8.member[2u];
let _e1787 = (_e1775 + _e1786);
let _e1789 = select(_e1434, _e1787, (_e1787 < _e1434));
let _e1794 = global_7.member[bitcast<u32>(select(0i, _e1789, (_e1789 > 0i)))];
let _e1796 = local_9[0u];
let _e1799 = (_e1785 + ((bitcast<f32>(_e1794) - _e1785) * _e1796));
let _e1800 = (_e1414 + _e1412);
let _e1801 = local_8.member[1u];
let _e1802 = (_e1800 + _e1801);
let _e1804 = select(_e1434, _e1802, (_e1802 < _e1434));
let _e1809 = global_7.member[bitcast<u32>(select(0i, _e1804, (_e1804 > 0i)))];
let _e1810 = bitcast<f32>(_e1809);
let _e1811 = local_8.member[2u];
let _e1812 = (_e1800 + _e1811);
let _e1814 = select(_e1434, _e1812, (_e1812 < _e1434));
let _e1819 = global_7.member[bitcast<u32>(select(0i, _e1814, (_e1814 > 0i)))];
let _e1821 = local_9[0u];
let _e1825 = (_e1417 + _e1412);
let _e1826 = local_8.member[1u];
let _e1827 = (_e1825 + _e1826);
let _e1829 = select(_e1434, _e1827, (_e1827 < _e1434));
let _e1834 = global_7.member[bitcast<u32>(select(0i, _e1829, (_e1829 > 0i)))];
let _e1835 = bitcast<f32>(_e1834);
let _e1836 = local_8.member[2u];
let _e1837 = (_e1825 + _e1836);
let _e1839 = select(_e1434, _e1837, (_e1837 < _e1434));
let _e1844 = global_7.member[bitcast<u32>(select(0i, _e1839, (_e1839 > 0i)))];
let _e1846 = local_9[0u];
let _e1851 = local_9[1u];
let _e1854 = (_e1486 + ((_e1539 - _e1486) * _e1851));
let _e1855 = local_9[1u];
let _e1858 = (_e1592 + ((_e1645 - _e1592) * _e1855));
let _e1859 = local_9[1u];
let _e1862 = (_e1482 + (((_e1501 + ((_e1511 - _e1501) * _e1532)) - _e1482) * _e1859));
let _e1863 = local_9[1u];
let _e1868 = local_9[2u];
let _e1872 = local_9[1u];
let _e1875 = (_e1490 + (((_e1521 + ((bitcast<f32>(_e1530) - _e1521) * _e1540)) - _e1490) * _e1872));
let _e1876 = local_9[1u];
let _e1880 = local_9[2u];
let _e1884 = local_9[1u];
let _e1887 = (_e1674 + ((_e1486 - _e1674) * _e1884));
let _e1888 = local_9[1u];
let _e1892 = local_9[2u];
let _e1896 = local_9[1u];
let _e1899 = (_e1539 + (((_e1685 + ((bitcast<f32>(_e1694) - _e1685) * _e1696)) - _e1539) * _e1896));
let _e1900 = local_9[1u];
let _e1904 = local_9[2u];
let _e1908 = local_9[1u];
let _e1911 = (_e1774 + (((_e1810 + ((bitcast<f32>(_e1819) - _e1810) * _e1821)) - _e1774) * _e1908));
let _e1912 = local_9[2u];
let _e1916 = local_9[1u];
let _e1920 = local_9[2u];
let _e1924 = local_9[2u];
let _e1932 = global_5.member[_e359].member_7.member_5;
let _e1938 = global_5.member[_e359].member_7.member_6;
let _e1939 = (((_e1854 + ((_e1858 - _e1854) * _e1924)) * _e1932) + _e1938);
let _e1941 = select(0f, _e1939, (_e1939 > 0f));
let _e1945 = (((_e1862 + (((_e1588 + (((_e1607 + ((_e1617 - _e1607) * _e1638)) - _e1588) * _e1863)) - _e1862) * _e1868)) * _e1932) + _e1938);
let _e1947 = select(0f, _e1945, (_e1945 > 0f));
let _e1949 = select(1f, _e1947, (_e1947 < 1f));
let _e1951 = (((_e1875 + (((_e1596 + (((_e1627 + ((bitcast<f32>(_e1636) - _e1627) * _e1646)) - _e1596) * _e1876)) - _e1875) * _e1880)) * _e1932) + _e1938);
let _e1953 = select(0f, _e1951, (_e1951 > 0f));
let _e1955 = select(1f, _e1953, (_e1953 < 1f));
let _e1957 = (((_e1887 + (((_e1724 + ((_e1592 - _e1724) * _e1888)) - _e1887) * _e1892)) * _e1932) + _e1938);
let _e1959 = select(0f, _e1957, (_e1957 > 0f));
let _e1961 = select(1f, _e1959, (_e1959 < 1f));
let _e1963 = (((_e1899 + (((_e1645 + (((_e1735 + ((bitcast<f32>(_e1744) - _e1735) * _e1746)) - _e1645) * _e1900)) - _e1899) * _e1904)) * _e1932) + _e1938);
let _e1965 = select(0f, _e1963, (_e1963 > 0f));
let _e1967 = select(1f, _e1965, (_e1965 < 1f));
let _e1969 = (((_e1911 + ((_e1854 - _e1911) * _e1912)) * _e1932) + _e1938);
let _e1971 = select(0f, _e1969, (_e1969 > 0f));
let _e1973 = select(1f, _e1971, (_e1971 < 1f));
let _e1975 = (((_e1858 + (((_e1799 + (((_e1835 + ((bitcast<f32>(_e1844) - _e1835) * _e1846)) - _e1799) * _e1916)) - _e1858) * _e1920)) * _e1932) + _e1938);
let _e1977 = select(0f, _e1975, (_e1975 > 0f));
let _e1979 = select(1f, _e1977, (_e1977 < 1f));
let _e1980 = (select(1f, _e1941, (_e1941 < 1f)) * 1024f);
let _e1981 = (1024f - 1f);
let _e1983 = select(0f, _e1980, (_e1980 > 0f));
let _e1985 = select(_e1981, _e1983, (_e1983 < _e1981));
let _e1992 = select(0i, select(select(i32(_e1985), i32(-2147483648), (_e1985 < -2147483600f)), 2147483647i, (_e1985 > 2147483500f)), (_e1985 == _e1985));
let _e1996 = (_e1992 - select(0i, 1i, (_e1985 < f32(_e1992))));
let _e1997 = (262147i + _e1996);
let _e1999 = (bitcast<i32>(_e130) - 1i);
let _e2001 = select(_e1999, _e1997, (_e1997 < _e1999));
let _e2007 = global_3.member[bitcast<u32>(select(0i, _e2001, (_e2001 > 0i)))];
let _e2017 = select(_e1999, 262146i, (262146i < _e1999));
let _e2023 = global_3.member[bitcast<u32>(select(0i, _e2017, (_e2017 > 0i)))];
let _e2024 = bitcast<f32>(_e2023);
let _e2025 = (f32((bitcast<i32>((_e2007 & 4095u)) - 2048i)) * _e2024);
let _e2027 = select(_e1999, 262144i, (262144i < _e1999));
let _e2033 = global_3.member[bitcast<u32>(select(0i, _e2027, (_e2027 > 0i)))];
let _e2034 = bitcast<f32>(_e2033);
let _e2036 = select(_e1999, 262145i, (262145i < _e1999));
let _e2042 = global_3.member[bitcast<u32>(select(0i, _e2036, (_e2036 > 0i)))];
let _e2043 = bitcast<f32>(_e2042);
let _e2049 = ((_e2034 + (f32(bitcast<i32>((_e2007 >> bitcast<u32>(12u)))) * _e2043)) + (_e2025 * (_e1980 - f32(_e1996))));
let _e2050 = (_e2025 * 1024f);
if _e1044 {
let _e2057 = ((0.5f * (_e1955 - _e1949)) * _e2050);
let _e2058 = ((0.5f * (_e1967 - _e1961)) * _e2050);
let _e2059 = ((0.5f * (_e1979 - _e1973)) * _e2050);
phi_5037_ = type_29(_e2049, vec3<f32>(_e2057, _e2058, _e2059), vec3<f32>((_e2057 * _e2049), (_e2058 * _e2049), (_e2059 * _e2049)));
} else {
let _e2066 = (_e1949 * 1024f);
let _e2068 = select(0f, _e2066, (_e2066 > 0f));
let _e2070 = select(_e1981, _e2068, (_e2068 < _e1981));
let _e2077 = select(0i, select(select(i32(_e2070), i32(-2147483648), (_e2070 < -2147483600f)), 2147483647i, (_e2070 > 2147483500f)), (_e2070 == _e2070));
let _e2081 = (_e2077 - select(0i, 1i, (_e2070 < f32(_e2077))));
let _e2082 = (262147i + _e2081);
let _e2084 = select(_e1999, _e2082, (_e2082 < _e1999));
let _e2090 = global_3.member[bitcast<u32>(select(0i, _e2084, (_e2084 > 0i)))];
let _e2105 = ((_e2034 + (f32(bitcast<i32>((_e2090 >> bitcast<u32>(12u)))) * _e2043)) + ((f32((bitcast<i32>((_e2090 & 4095u)) - 2048i)) * _e2024) * (_e2066 - f32(_e2081))));
let _e2106 = (_e1955 * 1024f);
let _e2108 = select(0f, _e2106, (_e2106 > 0f));
let _e2110 = select(_e1981, _e2108, (_e2108 < _e1981));
let _e2117 = select(0i, select(select(i32(_e2110), i32(-2147483648), (_e2110 < -2147483600f)), 2147483647i, (_e2110 > 2147483500f)), (_e2110 == _e2110));
let _e2121 = (_e2117 - select(0i, 1i, (_e2110 < f32(_e2117))));
let _e2122 = (262147i + _e2121);
let _e2124 = select(_e1999, _e2122, (_e2122 < _e1999));
let _e2130 = global_3.member[bitcast<u32>(select(0i, _e2124, (_e2124 > 0i)))];
let _e2145 = ((_e2034 + (f32(bitcast<i32>((_e2130 >> bitcast<u32>(12u)))) * _e2043)) + ((f32((bitcast<i32>((_e2130 & 4095u)) - 2048i)) * _e2024) * (_e2106 - f32(_e2121))));
let _e2146 = (_e1961 * 1024f);
let _e2148 = select(0f, _e2146, (_e2146 > 0f));
let _e2150 = select(_e1981, _e2148, (_e2148 < _e1981));
let _e2157 = select(0i, select(select(i32(_e2150), i32(-2147483648), (_e2150 < -2147483600f)), 2147483647i, (_e2150 > 2147483500f)), (_e2150 == _e2150));
let _e2161 = (_e2157 - select(0i, 1i, (_e2150 < f32(_e2157))));
let _e2162 = (262147i + _e2161);
let _e2164 = select(_e1999, _e2162, (_e2162 < _e1999));
let _e2170 = global_3.member[bitcast<u32>(select(0i, _e2164, (_e2164 > 0i)))];
let _e2185 = ((_e2034 + (f32(bitcast<i32>((_e2170 >> bitcast<u32>(12u)))) * _e2043)) + ((f32((bitcast<i32>((_e2170 & 4095u)) - 2048i)) * _e2024) * (_e2146 - f32(_e2161))));
let _e2186 = (_e1967 * 1024f);
let _e2188 = select(0f, _e2186, (_e2186 > 0f));
let _e2190 = select(_e1981, _e2188, (_e2188 < _e1981));
let _e2197 = select(0i, select(select(i32(_e2190), i32(-2147483648), (_e2190 < -2147483600f)), 2147483647i, (_e2190 > 2147483500f)), (_e2190 == _e2190));
let _e2201 = (_e2197 - select(0i, 1i, (_e2190 < f32(_e2197))));
let _e2202 = (262147i + _e2201);
let _e2204 = select(_e1999, _e2202, (_e2202 < _e1999));
let _e2210 = global_3.member[bitcast<u32>(select(0i, _e2204, (_e2204 > 0i)))];
let _e2225 = ((_e2034 + (f32(bitcast<i32>((_e2210 >> bitcast<u32>(12u)))) * _e2043)) + ((f32((bitcast<i32>((_e2210 & 4095u)) - 2048i)) * _e2024) * (_e2186 - f32(_e2201))));
let _e2226 = (_e1973 * 1024f);
let _e2228 = select(0f, _e2226, (_e2226 > 0f));
let _e2230 = select(_e1981, _e2228, (_e2228 < _e1981));
let _e2237 = select(0i, select(select(i32(_e2230), i32(-2147483648), (_e2230 < -2147483600f)), 2147483647i, (_e2230 > 2147483500f)), (_e2230 == _e2230));
let _e2241 = (_e2237 - select(0i, 1i, (_e2230 < f32(_e2237))));
let _e2242 = (262147i + _e2241);
let _e2244 = select(_e1999, _e2242, (_e2242 < _e1999));
let _e2250 = global_3.member[bitcast<u32>(select(0i, _e2244, (_e2244 > 0i)))];
let _e2265 = ((_e2034 + (f32(bitcast<i32>((_e2250 >> bitcast<u32>(12u)))) * _e2043)) + ((f32((bitcast<i32>((_e2250 & 4095u)) - 2048i)) * _e2024) * (_e2226 - f32(_e2241))));
let _e2266 = (_e1979 * 1024f);
let _e2268 = select(0f, _e2266, (_e2266 > 0f));
let _e2270 = select(_e1981, _e2268, (_e2268 < _e1981));
let _e2277 = select(0i, select(select(i32(_e2270), i32(-2147483648), (_e2270 < -2147483600f)), 2147483647i, (_e2270 > 2147483500f)), (_e2270 == _e2270));
let _e2281 = (_e2277 - select(0i, 1i, (_e2270 < f32(_e2277))));
let _e2282 = (262147i + _e2281);
let _e2284 = select(_e1999, _e2282, (_e2282 < _e1999));
let _e2290 = global_3.member[bitcast<u32>(select(0i, _e2284, (_e2284 > 0i)))];
let _e2305 = ((_e2034 + (f32(bitcast<i32>((_e2290 >> bitcast<u32>(12u)))) * _e2043)) + ((f32((bitcast<i32>((_e2290 & 4095u)) - 2048i)) * _e2024) * (_e2266 - f32(_e2281))));
let _e2306 = (_e2145 - _e2105);
let _e2308 = (_e2225 - _e2185);
let _e2310 = (_e2305 - _e2265);
phi_5037_ = type_29(_e2049, vec3<f32>((0.5f * _e2306), (0.5f * _e2308), (0.5f * _e2310)), vec3<f32>((0.25f * (_e2306 * (_e2145 + _e2105))), (0.25f * (_e2308 * (_e2225 + _e2185))), (0.25f * (_e2310 * (_e2305 + _e2265)))));
}
let _e2325 = phi_5037_;
let _e2340 = select(0f, 1f, ((((((_e744 >= -0.5f) && (_e744 <= _e768)) && (_e750 >= -0.5f)) && (_e750 <= _e779)) && (_e756 >= -0.5f)) && (_e756 <= _e790)));
let _e2342 = (0.5f * (_e1955 - _e1949));
let _e2344 = (0.5f * (_e1967 - _e1961));
let _e2346 = (0.5f * (_e1979 - _e1973));
let _e2353 = global_5.member[_e359].member_7.member.member.member;
let _e2360 = global_5.member[_e359].member_7.member.member.member_1;
let _e2367 = global_5.member[_e359].member_7.member.member.member_2;
let _e2374 = global_5.member[_e359].member_7.member_1.member.member;
let _e2381 = global_5.member[_e359].member_7.member_1.member.member_1;
let _e2388 = global_5.member[_e359].member_7.member_1.member.member_2;
let _e2395 = global_5.member[_e359].member_7.member_2.member.member;
let _e2402 = global_5.member[_e359].member_7.member_2.member.member_1;
let _e2409 = global_5.member[_e359].member_7.member_2.member.member_2;
phi_5683_ = type_30(select(1f, _e1295, (_e1295 < 1f)), vec3<f32>(((((_e2353 * _e2342) + (_e2374 * _e2344)) + (_e2395 * _e2346)) * _e2340), ((((_e2360 * _e2342) + (_e2381 * _e2344)) + (_e2402 * _e2346)) * _e2340), ((((_e2367 * _e2342) + (_e2388 * _e2344)) + (_e2409 * _e2346)) * _e2340)), _e2325.member, vec3<f32>(((((_e2353 * _e2325.member_2.x) + (_e2374 * _e2325.member_2.y)) + (_e2395 * _e2325.member_2.z)) * _e2340), ((((_e2360 * _e2325.member_2.x) + (_e2381 * _e2325.member_2.y)) + (_e2402 * _e2325.member_2.z)) * _e2340), ((((_e2367 * _e2325.member_2.x) + (_e2388 * _e2325.member_2.y)) + (_e2409 * _e2325.member_2.z)) * _e2340)), vec3<f32>(((((_e2353 * _e2325.member_1.x) + (_e2374 * _e2325.member_1.y)) + (_e2395 * _e2325.member_1.z)) * _e2340), ((((_e2360 * _e2325.member_1.x) + (_e2381 * _e2325.member_1.y)) + (_e2402 * _e2325.member_1.z)) * _e2340), ((((_e2367 * _e2325.member_1.x) + (_e2388 * _e2325.member_1.y)) + (_e2409 * _e2325.member_1.z)) * _e2340)));
} else {
let _e2475 = select(-1f, _e533, (_e533 > -1f));
let _e2477 = select(_e528, _e2475, (_e2475 < _e528));
let _e2484 = select(0i, select(select(i32(_e2477), i32(-2147483648), (_e2477 < -2147483600f)), 2147483647i, (_e2477 > 2147483500f)), (_e2477 == _e2477));
let _e2488 = (_e2484 - select(0i, 1i, (_e2477 < f32(_e2484))));
let _e2490 = select(-1f, _e544, (_e544 > -1f));
let _e2492 = select(_e539, _e2490, (_e2490 < _e539));
let _e2499 = select(0i, select(select(i32(_e2492), i32(-2147483648), (_e2492 < -2147483600f)), 2147483647i, (_e2492 > 2147483500f)), (_e2492 == _e2492));
let _e2503 = (_e2499 - select(0i, 1i, (_e2492 < f32(_e2499))));
let _e2505 = select(-1f, _e555, (_e555 > -1f));
let _e2507 = select(_e550, _e2505, (_e2505 < _e550));
let _e2514 = select(0i, select(select(i32(_e2507), i32(-2147483648), (_e2507 < -2147483600f)), 2147483647i, (_e2507 > 2147483500f)), (_e2507 == _e2507));
let _e2518 = (_e2514 - select(0i, 1i, (_e2507 < f32(_e2514))));
let _e2523 = global_5.member[_e359].member_6.member_7;
let _e2528 = global_5.member[_e359].member_6.member_8;
let _e2536 = (select(0i, select(select(i32(_e539), i32(-2147483648), (_e539 < -2147483600f)), 2147483647i, (_e539 > 2147483500f)), (_e539 == _e539)) - 1i);
let _e2539 = (_e2503 + 1i);
let _e2549 = (select(0i, select(select(i32(_e550), i32(-2147483648), (_e550 < -2147483600f)), 2147483647i, (_e550 > 2147483500f)), (_e550 == _e550)) - 1i);
let _e2552 = (_e2518 + 1i);
let _e2562 = (select(0i, select(select(i32(_e528), i32(-2147483648), (_e528 < -2147483600f)), 2147483647i, (_e528 > 2147483500f)), (_e528 == _e528)) - 1i);
let _e2563 = (_e2488 - 1i);
let _e2568 = (_e2488 + 1i);
let _e2571 = (_e2488 + 2i);
let _e2574 = (select(0i, _e2503, (_e2503 > 0i)) * _e2523);
let _e2575 = (select(_e2536, _e2539, (_e2539 < _e2536)) * _e2523);
let _e2576 = (select(0i, _e2518, (_e2518 > 0i)) * _e2528);
let _e2577 = (select(_e2549, _e2552, (_e2552 < _e2549)) * _e2528);
local_6 = type_28(array<i32, 4>(select(0i, _e2563, (_e2563 > 0i)), select(0i, _e2488, (_e2488 > 0i)), select(_e2562, _e2568, (_e2568 < _e2562)), select(_e2562, _e2571, (_e2571 < _e2562))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_7 = vec3<f32>((_e533 - f32(_e2488)), (_e544 - f32(_e2503)), (_e555 - f32(_e2518)));
let _e2588 = (_e2576 + _e2574);
let _e2591 = local_6.member[1u];
let _e2592 = (_e2588 + _e2591);
let _e2594 = (bitcast<i32>(_e123) - 1i);
let _e2596 = select(_e2594, _e2592, (_e2592 < _e2594));
let _e2601 = global_1.member[bitcast<u32>(select(0i, _e2596, (_e2596 > 0i)))];
let _e2602 = bitcast<f32>(_e2601);
let _e2605 = local_6.member[2u];
let _e2606 = (_e2588 + _e2605);
let _e2608 = select(_e2594, _e2606, (_e2606 < _e2594));
let _e2613 = global_1.member[bitcast<u32>(select(0i, _e2608, (_e2608 > 0i)))];
let _e2615 = local_7[0u];
let _e2618 = (_e2602 + ((bitcast<f32>(_e2613) - _e2602) * _e2615));
let _e2619 = (_e2576 + _e2575);
let _e2620 = local_6.member[1u];
let _e2621 = (_e2619 + _e2620);
let _e2623 = select(_e2594, _e2621, (_e2621 < _e2594));
let _e2628 = global_1.member[bitcast<u32>(select(0i, _e2623, (_e2623 > 0i)))];
let _e2629 = bitcast<f32>(_e2628);
let _e2630 = local_6.member[2u];
let _e2631 = (_e2619 + _e2630);
let _e2633 = select(_e2594, _e2631, (_e2631 < _e2594));
let _e2638 = global_1.member[bitcast<u32>(select(0i, _e2633, (_e2633 > 0i)))];
let _e2640 = local_7[0u];
let _e2645 = local_7[1u];
let _e2648 = (_e2618 + (((_e2629 + ((bitcast<f32>(_e2638) - _e2629) * _e2640)) - _e2618) * _e2645));
let _e2649 = (_e2577 + _e2574);
let _e2650 = local_6.member[1u];
let _e2651 = (_e2649 + _e2650);
let _e2653 = select(_e2594, _e2651, (_e2651 < _e2594));
let _e2658 = global_1.member[bitcast<u32>(select(0i, _e2653, (_e2653 > 0i)))];
let _e2659 = bitcast<f32>(_e2658);
let _e2660 = local_6.member[2u];
let _e2661 = (_e2649 + _e2660);
let _e2663 = select(_e2594, _e2661, (_e2661 < _e2594));
let _e2668 = global_1.member[bitcast<u32>(select(0i, _e2663, (_e2663 > 0i)))];
let _e2670 = local_7[0u];
let _e2673 = (_e2659 + ((bitcast<f32>(_e2668) - _e2659) * _e2670));
let _e2674 = (_e2577 + _e2575);
let _e2675 = local_6.member[1u];
let _e2676 = (_e2674 + _e2675);
let _e2678 = select(_e2594, _e2676, (_e2676 < _e2594));
let _e2683 = global_1.member[bitcast<u32>(select(0i, _e2678, (_e2678 > 0i)))];
let _e2684 = bitcast<f32>(_e2683);
let _e2685 = local_6.member[2u];
let _e2686 = (_e2674 + _e2685);
let _e2688 = select(_e2594, _e2686, (_e2686 < _e2594));
let _e2693 = global_1.member[bitcast<u32>(select(0i, _e2688, (_e2688 > 0i)))];
let _e2695 = local_7[0u];
let _e2699 = local_7[1u];
let _e2704 = local_7[2u];
let _e2712 = global_5.member[_e359].member_6.member_5;
let _e2718 = global_5.member[_e359].member_6.member_6;
let _e2719 = (((_e2648 + (((_e2673 + (((_e2684 + ((bitcast<f32>(_e2693) - _e2684) * _e2695)) - _e2673) * _e2699)) - _e2648) * _e2704)) * _e2712) + _e2718);
let _e2721 = select(0f, _e2719, (_e2719 > 0f));
phi_5683_ = type_30(select(1f, _e2721, (_e2721 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2726 = phi_5683_;
let _e2728 = select(-0.5f, _e467, (_e467 > -0.5f));
let _e2730 = select(_e529, _e2728, (_e2728 < _e529));
let _e2732 = select(-0.5f, _e483, (_e483 > -0.5f));
let _e2734 = select(_e540, _e2732, (_e2732 < _e540));
let _e2736 = select(-0.5f, _e499, (_e499 > -0.5f));
let _e2738 = select(_e551, _e2736, (_e2736 < _e551));
let _e2740 = select(-1f, _e2730, (_e2730 > -1f));
let _e2742 = select(_e528, _e2740, (_e2740 < _e528));
let _e2749 = select(0i, select(select(i32(_e2742), i32(-2147483648), (_e2742 < -2147483600f)), 2147483647i, (_e2742 > 2147483500f)), (_e2742 == _e2742));
let _e2753 = (_e2749 - select(0i, 1i, (_e2742 < f32(_e2749))));
let _e2755 = select(-1f, _e2734, (_e2734 > -1f));
let _e2757 = select(_e539, _e2755, (_e2755 < _e539));
let _e2764 = select(0i, select(select(i32(_e2757), i32(-2147483648), (_e2757 < -2147483600f)), 2147483647i, (_e2757 > 2147483500f)), (_e2757 == _e2757));
let _e2768 = (_e2764 - select(0i, 1i, (_e2757 < f32(_e2764))));
let _e2770 = select(-1f, _e2738, (_e2738 > -1f));
let _e2772 = select(_e550, _e2770, (_e2770 < _e550));
let _e2779 = select(0i, select(select(i32(_e2772), i32(-2147483648), (_e2772 < -2147483600f)), 2147483647i, (_e2772 > 2147483500f)), (_e2772 == _e2772));
let _e2783 = (_e2779 - select(0i, 1i, (_e2772 < f32(_e2779))));
let _e2788 = global_5.member[_e359].member_6.member_7;
let _e2793 = global_5.member[_e359].member_6.member_8;
let _e2801 = (select(0i, select(select(i32(_e539), i32(-2147483648), (_e539 < -2147483600f)), 2147483647i, (_e539 > 2147483500f)), (_e539 == _e539)) - 1i);
let _e2804 = (_e2768 + 1i);
let _e2814 = (select(0i, select(select(i32(_e550), i32(-2147483648), (_e550 < -2147483600f)), 2147483647i, (_e550 > 2147483500f)), (_e550 == _e550)) - 1i);
let _e2817 = (_e2783 + 1i);
let _e2827 = (select(0i, select(select(i32(_e528), i32(-2147483648), (_e528 < -2147483600f)), 2147483647i, (_e528 > 2147483500f)), (_e528 == _e528)) - 1i);
let _e2828 = (_e2753 - 1i);
let _e2833 = (_e2753 + 1i);
let _e2836 = (_e2753 + 2i);
let _e2839 = (select(0i, _e2768, (_e2768 > 0i)) * _e2788);
let _e2840 = (select(_e2801, _e2804, (_e2804 < _e2801)) * _e2788);
let _e2841 = (select(0i, _e2783, (_e2783 > 0i)) * _e2793);
let _e2842 = (select(_e2814, _e2817, (_e2817 < _e2814)) * _e2793);
local_4 = type_28(array<i32, 4>(select(0i, _e2828, (_e2828 > 0i)), select(0i, _e2753, (_e2753 > 0i)), select(_e2827, _e2833, (_e2833 < _e2827)), select(_e2827, _e2836, (_e2836 < _e2827))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_5 = vec3<f32>((_e2730 - f32(_e2753)), (_e2734 - f32(_e2768)), (_e2738 - f32(_e2783)));
let _e2853 = (_e2841 + _e2839);
let _e2856 = local_4.member[1u];
let _e2857 = (_e2853 + _e2856);
let _e2859 = (bitcast<i32>(_e123) - 1i);
let _e2861 = select(_e2859, _e2857, (_e2857 < _e2859));
let _e2866 = global_1.member[bitcast<u32>(select(0i, _e2861, (_e2861 > 0i)))];
let _e2867 = bitcast<f32>(_e2866);
let _e2870 = local_4.member[2u];
let _e2871 = (_e2853 + _e2870);
let _e2873 = select(_e2859, _e2871, (_e2871 < _e2859));
let _e2878 = global_1.member[bitcast<u32>(select(0i, _e2873, (_e2873 > 0i)))];
let _e2880 = local_5[0u];
let _e2883 = (_e2867 + ((bitcast<f32>(_e2878) - _e2867) * _e2880));
let _e2884 = (_e2841 + _e2840);
let _e2885 = local_4.member[1u];
let _e2886 = (_e2884 + _e2885);
let _e2888 = select(_e2859, _e2886, (_e2886 < _e2859));
let _e2893 = global_1.member[bitcast<u32>(select(0i, _e2888, (_e2888 > 0i)))];
let _e2894 = bitcast<f32>(_e2893);
let _e2895 = local_4.member[2u];
let _e2896 = (_e2884 + _e2895);
let _e2898 = select(_e2859, _e2896, (_e2896 < _e2859));
let _e2903 = global_1.member[bitcast<u32>(select(0i, _e2898, (_e2898 > 0i)))];
let _e2905 = local_5[0u];
let _e2910 = local_5[1u];
let _e2913 = (_e2883 + (((_e2894 + ((bitcast<f32>(_e2903) - _e2894) * _e2905)) - _e2883) * _e2910));
let _e2914 = (_e2842 + _e2839);
let _e2915 = local_4.member[1u];
let _e2916 = (_e2914 + _e2915);
let _e2918 = select(_e2859, _e2916, (_e2916 < _e2859));
let _e2923 = global_1.member[bitcast<u32>(select(0i, _e2918, (_e2918 > 0i)))];
let _e2924 = bitcast<f32>(_e2923);
let _e2925 = local_4.member[2u];
let _e2926 = (_e2914 + _e2925);
let _e2928 = select(_e2859, _e2926, (_e2926 < _e2859));
let _e2933 = global_1.member[bitcast<u32>(select(0i, _e2928, (_e2928 > 0i)))];
let _e2935 = local_5[0u];
let _e2938 = (_e2924 + ((bitcast<f32>(_e2933) - _e2924) * _e2935));
let _e2939 = (_e2842 + _e2840);
let _e2940 = local_4.member[1u];
let _e2941 = (_e2939 + _e2940);
let _e2943 = select(_e2859, _e2941, (_e2941 < _e2859));
let _e2948 = global_1.member[bitcast<u32>(select(0i, _e2943, (_e2943 > 0i)))];
let _e2949 = bitcast<f32>(_e2948);
let _e2950 = local_4.member[2u];
let _e2951 = (_e2939 + _e2950);
let _e2953 = select(_e2859, _e2951, (_e2951 < _e2859));
let _e2958 = global_1.member[bitcast<u32>(select(0i, _e2953, (_e2953 > 0i)))];
let _e2960 = local_5[0u];
let _e2964 = local_5[1u];
let _e2969 = local_5[2u];
let _e2977 = global_5.member[_e359].member_6.member_5;
let _e2983 = global_5.member[_e359].member_6.member_6;
let _e2984 = (((_e2913 + (((_e2938 + (((_e2949 + ((bitcast<f32>(_e2958) - _e2949) * _e2960)) - _e2938) * _e2964)) - _e2913) * _e2969)) * _e2977) + _e2983);
let _e2986 = select(0f, _e2984, (_e2984 > 0f));
let _e2989 = select(_e363[6], select(1f, _e2986, (_e2986 < 1f)), _e963);
if _e1047 {
let _e2991 = select(-0.5f, _e706, (_e706 > -0.5f));
let _e2993 = select(_e768, _e2991, (_e2991 < _e768));
let _e2995 = select(-0.5f, _e722, (_e722 > -0.5f));
let _e2997 = select(_e779, _e2995, (_e2995 < _e779));
let _e2999 = select(-0.5f, _e738, (_e738 > -0.5f));
let _e3001 = select(_e790, _e2999, (_e2999 < _e790));
let _e3003 = select(-1f, _e2993, (_e2993 > -1f));
let _e3005 = select(_e767, _e3003, (_e3003 < _e767));
let _e3012 = select(0i, select(select(i32(_e3005), i32(-2147483648), (_e3005 < -2147483600f)), 2147483647i, (_e3005 > 2147483500f)), (_e3005 == _e3005));
let _e3016 = (_e3012 - select(0i, 1i, (_e3005 < f32(_e3012))));
let _e3018 = select(-1f, _e2997, (_e2997 > -1f));
let _e3020 = select(_e778, _e3018, (_e3018 < _e778));
let _e3027 = select(0i, select(select(i32(_e3020), i32(-2147483648), (_e3020 < -2147483600f)), 2147483647i, (_e3020 > 2147483500f)), (_e3020 == _e3020));
let _e3031 = (_e3027 - select(0i, 1i, (_e3020 < f32(_e3027))));
let _e3033 = select(-1f, _e3001, (_e3001 > -1f));
let _e3035 = select(_e789, _e3033, (_e3033 < _e789));
let _e3042 = select(0i, select(select(i32(_e3035), i32(-2147483648), (_e3035 < -2147483600f)), 2147483647i, (_e3035 > 2147483500f)), (_e3035 == _e3035));
let _e3046 = (_e3042 - select(0i, 1i, (_e3035 < f32(_e3042))));
let _e3051 = global_5.member[_e359].member_7.member_7;
let _e3056 = global_5.member[_e359].member_7.member_8;
let _e3064 = (select(0i, select(select(i32(_e778), i32(-2147483648), (_e778 < -2147483600f)), 2147483647i, (_e778 > 2147483500f)), (_e778 == _e778)) - 1i);
let _e3067 = (_e3031 + 1i);
let _e3077 = (select(0i, select(select(i32(_e789), i32(-2147483648), (_e789 < -2147483600f)), 2147483647i, (_e789 > 2147483500f)), (_e789 == _e789)) - 1i);
let _e3080 = (_e3046 + 1i);
let _e3090 = (select(0i, select(select(i32(_e767), i32(-2147483648), (_e767 < -2147483600f)), 2147483647i, (_e767 > 2147483500f)), (_e767 == _e767)) - 1i);
let _e3091 = (_e3016 - 1i);
let _e3096 = (_e3016 + 1i);
let _e3099 = (_e3016 + 2i);
let _e3102 = (select(0i, _e3031, (_e3031 > 0i)) * _e3051);
let _e3103 = (select(_e3064, _e3067, (_e3067 < _e3064)) * _e3051);
let _e3104 = (select(0i, _e3046, (_e3046 > 0i)) * _e3056);
let _e3105 = (select(_e3077, _e3080, (_e3080 < _e3077)) * _e3056);
local_2 = type_28(array<i32, 4>(select(0i, _e3091, (_e3091 > 0i)), select(0i, _e3016, (_e3016 > 0i)), select(_e3090, _e3096, (_e3096 < _e3090)), select(_e3090, _e3099, (_e3099 < _e3090))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = vec3<f32>((_e2993 - f32(_e3016)), (_e2997 - f32(_e3031)), (_e3001 - f32(_e3046)));
let _e3116 = (_e3104 + _e3102);
let _e3119 = local_2.member[1u];
let _e3120 = (_e3116 + _e3119);
let _e3122 = (bitcast<i32>(_e126) - 1i);
let _e3124 = select(_e3122, _e3120, (_e3120 < _e3122));
let _e3129 = global_7.member[bitcast<u32>(select(0i, _e3124, (_e3124 > 0i)))];
let _e3130 = bitcast<f32>(_e3129);
let _e3133 = local_2.member[2u];
let _e3134 = (_e3116 + _e3133);
let _e3136 = select(_e3122, _e3134, (_e3134 < _e3122));
let _e3141 = global_7.member[bitcast<u32>(select(0i, _e3136, (_e3136 > 0i)))];
let _e3143 = local_3[0u];
let _e3146 = (_e3130 + ((bitcast<f32>(_e3141) - _e3130) * _e3143));
let _e3147 = (_e3104 + _e3103);
let _e3148 = local_2.member[1u];
let _e3149 = (_e3147 + _e3148);
let _e3151 = select(_e3122, _e3149, (_e3149 < _e3122));
let _e3156 = global_7.member[bitcast<u32>(select(0i, _e3151, (_e3151 > 0i)))];
let _e3157 = bitcast<f32>(_e3156);
let _e3158 = local_2.member[2u];
let _e3159 = (_e3147 + _e3158);
let _e3161 = select(_e3122, _e3159, (_e3159 < _e3122));
let _e3166 = global_7.member[bitcast<u32>(select(0i, _e3161, (_e3161 > 0i)))];
let _e3168 = local_3[0u];
let _e3173 = local_3[1u];
let _e3176 = (_e3146 + (((_e3157 + ((bitcast<f32>(_e3166) - _e3157) * _e3168)) - _e3146) * _e3173));
let _e3177 = (_e3105 + _e3102);
let _e3178 = local_2.member[1u];
let _e3179 = (_e3177 + _e3178);
let _e3181 = select(_e3122, _e3179, (_e3179 < _e3122));
let _e3186 = global_7.member[bitcast<u32>(select(0i, _e3181, (_e3181 > 0i)))];
let _e3187 = bitcast<f32>(_e3186);
let _e3188 = local_2.member[2u];
let _e3189 = (_e3177 + _e3188);
let _e3191 = select(_e3122, _e3189, (_e3189 < _e3122));
let _e3196 = global_7.member[bitcast<u32>(select(0i, _e3191, (_e3191 > 0i)))];
let _e3198 = local_3[0u];
let _e3201 = (_e3187 + ((bitcast<f32>(_e3196) - _e3187) * _e3198));
let _e3202 = (_e3105 + _e3103);
let _e3203 = local_2.member[1u];
let _e3204 = (_e3202 + _e3203);
let _e3206 = select(_e3122, _e3204, (_e3204 < _e3122));
let _e3211 = global_7.member[bitcast<u32>(select(0i, _e3206, (_e3206 > 0i)))];
let _e3212 = bitcast<f32>(_e3211);
let _e3213 = local_2.member[2u];
let _e3214 = (_e3202 + _e3213);
let _e3216 = select(_e3122, _e3214, (_e3214 < _e3122));
let _e3221 = global_7.member[bitcast<u32>(select(0i, _e3216, (_e3216 > 0i)))];
let _e3223 = local_3[0u];
let _e3227 = local_3[1u];
let _e3232 = local_3[2u];
let _e3240 = global_5.member[_e359].member_7.member_5;
let _e3246 = global_5.member[_e359].member_7.member_6;
let _e3247 = (((_e3176 + (((_e3201 + (((_e3212 + ((bitcast<f32>(_e3221) - _e3212) * _e3223)) - _e3201) * _e3227)) - _e3176) * _e3232)) * _e3240) + _e3246);
let _e3249 = select(0f, _e3247, (_e3247 > 0f));
let _e3252 = (select(1f, _e3249, (_e3249 < 1f)) * 1024f);
let _e3253 = (1024f - 1f);
let _e3255 = select(0f, _e3252, (_e3252 > 0f));
let _e3257 = select(_e3253, _e3255, (_e3255 < _e3253));
let _e3264 = select(0i, select(select(i32(_e3257), i32(-2147483648), (_e3257 < -2147483600f)), 2147483647i, (_e3257 > 2147483500f)), (_e3257 == _e3257));
let _e3268 = (_e3264 - select(0i, 1i, (_e3257 < f32(_e3264))));
let _e3269 = (262147i + _e3268);
let _e3271 = (bitcast<i32>(_e130) - 1i);
let _e3273 = select(_e3271, _e3269, (_e3269 < _e3271));
let _e3279 = global_3.member[bitcast<u32>(select(0i, _e3273, (_e3273 > 0i)))];
let _e3289 = select(_e3271, 262146i, (262146i < _e3271));
let _e3295 = global_3.member[bitcast<u32>(select(0i, _e3289, (_e3289 > 0i)))];
let _e3299 = select(_e3271, 262144i, (262144i < _e3271));
let _e3305 = global_3.member[bitcast<u32>(select(0i, _e3299, (_e3299 > 0i)))];
let _e3308 = select(_e3271, 262145i, (262145i < _e3271));
let _e3314 = global_3.member[bitcast<u32>(select(0i, _e3308, (_e3308 > 0i)))];
phi_6759_ = select(_e363[16], ((bitcast<f32>(_e3305) + (f32(bitcast<i32>((_e3279 >> bitcast<u32>(12u)))) * bitcast<f32>(_e3314))) + ((f32((bitcast<i32>((_e3279 & 4095u)) - 2048i)) * bitcast<f32>(_e3295)) * (_e3252 - f32(_e3268)))), _e963);
} else {
phi_6759_ = _e363[16];
}
let _e3324 = phi_6759_;
let _e3327 = select(1f, select(1f, _e1042, (_e1042 < 1f)), _e451);
if ((_e931 & 16u) == 0u) {
phi_7148_ = type_5(1f, 1f, 1f);
} else {
let _e3334 = global_5.member[_e359].member_14.member;
let _e3345 = ((((_e3334.member.member * _e387) + (_e3334.member.member_1 * _e389)) + (_e3334.member.member_2 * _e383)) + _e3334.member_1);
let _e3351 = ((((_e3334.member.member * _e391) + (_e3334.member.member_1 * _e393)) + (_e3334.member.member_2 * _e398)) + _e3334.member_1);
let _e3353 = select(_e3351, _e3345, (_e3345 < _e3351));
let _e3355 = select(_e3351, _e3345, (_e3345 > _e3351));
let _e3357 = (_e3355 - _e3353);
let _e3360 = (-(_e3353) / select(1e-30f, _e3357, (_e3357 > 1e-30f)));
let _e3362 = select(0f, _e3360, (_e3360 > 0f));
let _e3368 = select(select(select(1f, _e3362, (_e3362 < 1f)), 1f, (_e3355 <= 0f)), 0f, (_e3353 > 0f));
let _e3374 = global_5.member[_e359].member_14.member_1;
let _e3375 = (_e3374 != 0u);
let _e3386 = global_5.member[_e359].member_15.member;
let _e3397 = ((((_e3386.member.member * _e387) + (_e3386.member.member_1 * _e389)) + (_e3386.member.member_2 * _e383)) + _e3386.member_1);
let _e3403 = ((((_e3386.member.member * _e391) + (_e3386.member.member_1 * _e393)) + (_e3386.member.member_2 * _e398)) + _e3386.member_1);
let _e3405 = select(_e3403, _e3397, (_e3397 < _e3403));
let _e3407 = select(_e3403, _e3397, (_e3397 > _e3403));
let _e3409 = (_e3407 - _e3405);
let _e3412 = (-(_e3405) / select(1e-30f, _e3409, (_e3409 > 1e-30f)));
let _e3414 = select(0f, _e3412, (_e3412 > 0f));
let _e3420 = select(select(select(1f, _e3414, (_e3414 < 1f)), 1f, (_e3407 <= 0f)), 0f, (_e3405 > 0f));
let _e3426 = global_5.member[_e359].member_15.member_1;
let _e3427 = (_e3426 != 0u);
let _e3438 = global_5.member[_e359].member_16.member;
let _e3449 = ((((_e3438.member.member * _e387) + (_e3438.member.member_1 * _e389)) + (_e3438.member.member_2 * _e383)) + _e3438.member_1);
let _e3455 = ((((_e3438.member.member * _e391) + (_e3438.member.member_1 * _e393)) + (_e3438.member.member_2 * _e398)) + _e3438.member_1);
let _e3457 = select(_e3455, _e3449, (_e3449 < _e3455));
let _e3459 = select(_e3455, _e3449, (_e3449 > _e3455));
let _e3461 = (_e3459 - _e3457);
let _e3464 = (-(_e3457) / select(1e-30f, _e3461, (_e3461 > 1e-30f)));
let _e3466 = select(0f, _e3464, (_e3464 > 0f));
let _e3472 = select(select(select(1f, _e3466, (_e3466 < 1f)), 1f, (_e3459 <= 0f)), 0f, (_e3457 > 0f));
let _e3478 = global_5.member[_e359].member_16.member_1;
let _e3479 = (_e3478 != 0u);
let _e3490 = global_5.member[_e359].member_17.member;
let _e3501 = ((((_e3490.member.member * _e387) + (_e3490.member.member_1 * _e389)) + (_e3490.member.member_2 * _e383)) + _e3490.member_1);
let _e3507 = ((((_e3490.member.member * _e391) + (_e3490.member.member_1 * _e393)) + (_e3490.member.member_2 * _e398)) + _e3490.member_1);
let _e3509 = select(_e3507, _e3501, (_e3501 < _e3507));
let _e3511 = select(_e3507, _e3501, (_e3501 > _e3507));
let _e3513 = (_e3511 - _e3509);
let _e3516 = (-(_e3509) / select(1e-30f, _e3513, (_e3513 > 1e-30f)));
let _e3518 = select(0f, _e3516, (_e3516 > 0f));
let _e3524 = select(select(select(1f, _e3518, (_e3518 < 1f)), 1f, (_e3511 <= 0f)), 0f, (_e3509 > 0f));
let _e3530 = global_5.member[_e359].member_17.member_1;
let _e3531 = (_e3530 != 0u);
phi_7148_ = type_5(((((1f * _e3368) * _e3420) * _e3472) * _e3524), ((((1f * select(1f, _e3368, _e3375)) * select(1f, _e3420, _e3427)) * select(1f, _e3472, _e3479)) * select(1f, _e3524, _e3531)), ((((1f * select(1f, 0f, (_e3375 && (_e3351 > 0f)))) * select(1f, 0f, (_e3427 && (_e3403 > 0f)))) * select(1f, 0f, (_e3479 && (_e3455 > 0f)))) * select(1f, 0f, (_e3531 && (_e3507 > 0f)))));
}
let _e3540 = phi_7148_;
let _e3541 = (_e561 < 1e-12f);
let _e3543 = (1f / select(_e556, 1f, _e3541));
let _e3545 = ((-0.5f - _e467) * _e3543);
let _e3547 = ((_e529 - _e467) * _e3543);
let _e3553 = select(_e3547, _e3545, (_e3545 < _e3547));
let _e3555 = select(0f, _e3553, (_e3553 > 0f));
let _e3558 = select(select(1f, _e3555, (_e3555 < 1f)), select(2f, 0f, ((_e467 >= -0.5f) && (_e467 <= _e529))), _e3541);
let _e3560 = select(_e3547, _e3545, (_e3545 > _e3547));
let _e3562 = select(0f, _e3560, (_e3560 > 0f));
let _e3565 = select(select(1f, _e3562, (_e3562 < 1f)), 1f, _e3541);
let _e3566 = (_e564 < 1e-12f);
let _e3568 = (1f / select(_e557, 1f, _e3566));
let _e3570 = ((-0.5f - _e483) * _e3568);
let _e3572 = ((_e540 - _e483) * _e3568);
let _e3578 = select(_e3572, _e3570, (_e3570 < _e3572));
let _e3580 = select(0f, _e3578, (_e3578 > 0f));
let _e3583 = select(select(1f, _e3580, (_e3580 < 1f)), select(2f, 0f, ((_e483 >= -0.5f) && (_e483 <= _e540))), _e3566);
let _e3585 = select(_e3572, _e3570, (_e3570 > _e3572));
let _e3587 = select(0f, _e3585, (_e3585 > 0f));
let _e3590 = select(select(1f, _e3587, (_e3587 < 1f)), 1f, _e3566);
let _e3591 = (_e569 < 1e-12f);
let _e3593 = (1f / select(_e558, 1f, _e3591));
let _e3595 = ((-0.5f - _e499) * _e3593);
let _e3597 = ((_e551 - _e499) * _e3593);
let _e3603 = select(_e3597, _e3595, (_e3595 < _e3597));
let _e3605 = select(0f, _e3603, (_e3603 > 0f));
let _e3608 = select(select(1f, _e3605, (_e3605 < 1f)), select(2f, 0f, ((_e499 >= -0.5f) && (_e499 <= _e551))), _e3591);
let _e3610 = select(_e3597, _e3595, (_e3595 > _e3597));
let _e3612 = select(0f, _e3610, (_e3610 > 0f));
let _e3615 = select(select(1f, _e3612, (_e3612 < 1f)), 1f, _e3591);
let _e3617 = select(_e3590, _e3565, (_e3565 < _e3590));
let _e3621 = select(_e3583, _e3558, (_e3558 > _e3583));
let _e3624 = (select(_e3615, _e3617, (_e3617 < _e3615)) - select(_e3608, _e3621, (_e3621 > _e3608)));
let _e3627 = (_e391 - _e387);
let _e3628 = (_e393 - _e389);
let _e3629 = (_e398 - _e383);
let _e3634 = (((_e3627 * _e3627) + (_e3628 * _e3628)) + (_e3629 * _e3629));
let _e3644 = global_5.member[_e359].member_5.member_3;
let _e3645 = (((sqrt(select(0f, _e3634, (_e3634 > 0f))) * select(0f, _e3624, (_e3624 > 0f))) * _e3327) * _e3644);
let _e3646 = (_e973.member_2 >= 3u);
if _e3646 {
let _e3648 = (_e2989 * 255f);
let _e3649 = (_e2726.member * 255f);
let _e3650 = (255f - 1f);
let _e3652 = select(0f, _e3648, (_e3648 > 0f));
let _e3654 = select(_e3650, _e3652, (_e3652 < _e3650));
let _e3661 = select(0i, select(select(i32(_e3654), i32(-2147483648), (_e3654 < -2147483600f)), 2147483647i, (_e3654 > 2147483500f)), (_e3654 == _e3654));
let _e3665 = (_e3661 - select(0i, 1i, (_e3654 < f32(_e3661))));
let _e3667 = select(0f, _e3649, (_e3649 > 0f));
let _e3669 = select(_e3650, _e3667, (_e3667 < _e3650));
let _e3676 = select(0i, select(select(i32(_e3669), i32(-2147483648), (_e3669 < -2147483600f)), 2147483647i, (_e3669 > 2147483500f)), (_e3669 == _e3669));
let _e3680 = (_e3676 - select(0i, 1i, (_e3669 < f32(_e3676))));
let _e3683 = (((_e3665 * 256i) + _e3680) * 4i);
let _e3685 = (_e3648 - f32(_e3665));
let _e3687 = (_e3649 - f32(_e3680));
let _e3688 = (_e3683 + 2i);
let _e3690 = (bitcast<i32>(_e130) - 1i);
let _e3692 = select(_e3690, _e3688, (_e3688 < _e3690));
let _e3698 = global_3.member[bitcast<u32>(select(0i, _e3692, (_e3692 > 0i)))];
let _e3699 = (_e3683 + 6i);
let _e3701 = select(_e3690, _e3699, (_e3699 < _e3690));
let _e3707 = global_3.member[bitcast<u32>(select(0i, _e3701, (_e3701 > 0i)))];
let _e3708 = (_e3683 + 1026i);
let _e3710 = select(_e3690, _e3708, (_e3708 < _e3690));
let _e3716 = global_3.member[bitcast<u32>(select(0i, _e3710, (_e3710 > 0i)))];
let _e3717 = (_e3683 + 1030i);
let _e3719 = select(_e3690, _e3717, (_e3717 < _e3690));
let _e3725 = global_3.member[bitcast<u32>(select(0i, _e3719, (_e3719 > 0i)))];
let _e3730 = (bitcast<f32>(((_e3698 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3738 = (_e3730 + (((bitcast<f32>(((_e3707 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3730) * _e3687));
let _e3743 = (bitcast<f32>(((_e3716 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3767 = (bitcast<f32>((((_e3698 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3775 = (_e3767 + (((bitcast<f32>((((_e3707 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3767) * _e3687));
let _e3780 = (bitcast<f32>((((_e3716 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3792 = (_e3683 + 3i);
let _e3794 = select(_e3690, _e3792, (_e3792 < _e3690));
let _e3800 = global_3.member[bitcast<u32>(select(0i, _e3794, (_e3794 > 0i)))];
let _e3801 = (_e3683 + 7i);
let _e3803 = select(_e3690, _e3801, (_e3801 < _e3690));
let _e3809 = global_3.member[bitcast<u32>(select(0i, _e3803, (_e3803 > 0i)))];
let _e3810 = (_e3683 + 1027i);
let _e3812 = select(_e3690, _e3810, (_e3810 < _e3690));
let _e3818 = global_3.member[bitcast<u32>(select(0i, _e3812, (_e3812 > 0i)))];
let _e3819 = (_e3683 + 1031i);
let _e3821 = select(_e3690, _e3819, (_e3819 < _e3690));
let _e3827 = global_3.member[bitcast<u32>(select(0i, _e3821, (_e3821 > 0i)))];
let _e3832 = (bitcast<f32>(((_e3800 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3840 = (_e3832 + (((bitcast<f32>(((_e3809 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3832) * _e3687));
let _e3845 = (bitcast<f32>(((_e3818 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3869 = (bitcast<f32>((((_e3800 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3877 = (_e3869 + (((bitcast<f32>((((_e3809 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3869) * _e3687));
let _e3882 = (bitcast<f32>((((_e3818 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3893 = (_e3877 + (((_e3882 + (((bitcast<f32>((((_e3827 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3882) * _e3687)) - _e3877) * _e3685));
let _e3897 = -((_e3893 * (_e3645 * _e3540.member)));
let _e3899 = select(-87f, _e3897, (_e3897 > -87f));
let _e3901 = select(88f, _e3899, (_e3899 < 88f));
let _e3903 = ((_e3901 * 1.442695f) + 0.5f);
let _e3905 = select(-127f, _e3903, (_e3903 > -127f));
let _e3907 = select(128f, _e3905, (_e3905 < 128f));
let _e3914 = select(0i, select(select(i32(_e3907), i32(-2147483648), (_e3907 < -2147483600f)), 2147483647i, (_e3907 > 2147483500f)), (_e3907 == _e3907));
let _e3918 = (_e3914 - select(0i, 1i, (_e3907 < f32(_e3914))));
let _e3919 = f32(_e3918);
let _e3923 = ((_e3901 - (_e3919 * 0.6933594f)) - (_e3919 * -2.1219444e-4f));
let _e3943 = ((1f + (_e3923 * (1f + (_e3923 * (0.5f + (_e3923 * (0.16666667f + (_e3923 * (0.041666668f + (_e3923 * (0.008333334f + (_e3923 * (0.001388889f + (_e3923 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3918 + 127i)) << bitcast<u32>(23i))));
let _e3944 = (1f - _e3943);
let _e3947 = (_e3944 / select(1e-12f, _e3893, (_e3893 > 1e-12f)));
phi_8706_ = type_31(_e3943, _e3944, vec3<f32>(1f, 1f, 1f), vec3<f32>(((_e3738 + (((_e3743 + (((bitcast<f32>(((_e3725 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3743) * _e3687)) - _e3738) * _e3685)) * _e3947), ((_e3775 + (((_e3780 + (((bitcast<f32>((((_e3725 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3780) * _e3687)) - _e3775) * _e3685)) * _e3947), ((_e3840 + (((_e3845 + (((bitcast<f32>(((_e3827 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3845) * _e3687)) - _e3840) * _e3685)) * _e3947)));
} else {
let _e3954 = (_e2989 * 255f);
let _e3955 = (_e2726.member * 255f);
let _e3956 = (255f - 1f);
let _e3958 = select(0f, _e3954, (_e3954 > 0f));
let _e3960 = select(_e3956, _e3958, (_e3958 < _e3956));
let _e3967 = select(0i, select(select(i32(_e3960), i32(-2147483648), (_e3960 < -2147483600f)), 2147483647i, (_e3960 > 2147483500f)), (_e3960 == _e3960));
let _e3971 = (_e3967 - select(0i, 1i, (_e3960 < f32(_e3967))));
let _e3973 = select(0f, _e3955, (_e3955 > 0f));
let _e3975 = select(_e3956, _e3973, (_e3973 < _e3956));
let _e3982 = select(0i, select(select(i32(_e3975), i32(-2147483648), (_e3975 < -2147483600f)), 2147483647i, (_e3975 > 2147483500f)), (_e3975 == _e3975));
let _e3986 = (_e3982 - select(0i, 1i, (_e3975 < f32(_e3982))));
let _e3989 = (((_e3971 * 256i) + _e3986) * 4i);
let _e3991 = (_e3954 - f32(_e3971));
let _e3993 = (_e3955 - f32(_e3986));
let _e3995 = (bitcast<i32>(_e130) - 1i);
let _e3997 = select(_e3995, _e3989, (_e3989 < _e3995));
let _e4003 = global_3.member[bitcast<u32>(select(0i, _e3997, (_e3997 > 0i)))];
let _e4004 = (_e3989 + 4i);
let _e4006 = select(_e3995, _e4004, (_e4004 < _e3995));
let _e4012 = global_3.member[bitcast<u32>(select(0i, _e4006, (_e4006 > 0i)))];
let _e4013 = (_e3989 + 1024i);
let _e4015 = select(_e3995, _e4013, (_e4013 < _e3995));
let _e4021 = global_3.member[bitcast<u32>(select(0i, _e4015, (_e4015 > 0i)))];
let _e4022 = (_e3989 + 1028i);
let _e4024 = select(_e3995, _e4022, (_e4022 < _e3995));
let _e4030 = global_3.member[bitcast<u32>(select(0i, _e4024, (_e4024 > 0i)))];
let _e4035 = (bitcast<f32>(((_e4003 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4043 = (_e4035 + (((bitcast<f32>(((_e4012 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4035) * _e3993));
let _e4048 = (bitcast<f32>(((_e4021 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4059 = (_e4043 + (((_e4048 + (((bitcast<f32>(((_e4030 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4048) * _e3993)) - _e4043) * _e3991));
let _e4072 = (bitcast<f32>((((_e4003 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4080 = (_e4072 + (((bitcast<f32>((((_e4012 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4072) * _e3993));
let _e4085 = (bitcast<f32>((((_e4021 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4097 = (_e3989 + 1i);
let _e4099 = select(_e3995, _e4097, (_e4097 < _e3995));
let _e4105 = global_3.member[bitcast<u32>(select(0i, _e4099, (_e4099 > 0i)))];
let _e4106 = (_e3989 + 5i);
let _e4108 = select(_e3995, _e4106, (_e4106 < _e3995));
let _e4114 = global_3.member[bitcast<u32>(select(0i, _e4108, (_e4108 > 0i)))];
let _e4115 = (_e3989 + 1025i);
let _e4117 = select(_e3995, _e4115, (_e4115 < _e3995));
let _e4123 = global_3.member[bitcast<u32>(select(0i, _e4117, (_e4117 > 0i)))];
let _e4124 = (_e3989 + 1029i);
let _e4126 = select(_e3995, _e4124, (_e4124 < _e3995));
let _e4132 = global_3.member[bitcast<u32>(select(0i, _e4126, (_e4126 > 0i)))];
let _e4137 = (bitcast<f32>(((_e4105 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4145 = (_e4137 + (((bitcast<f32>(((_e4114 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4137) * _e3993));
let _e4150 = (bitcast<f32>(((_e4123 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4174 = (bitcast<f32>((((_e4105 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4182 = (_e4174 + (((bitcast<f32>((((_e4114 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4174) * _e3993));
let _e4187 = (bitcast<f32>((((_e4123 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4199 = (_e3989 + 2i);
let _e4201 = select(_e3995, _e4199, (_e4199 < _e3995));
let _e4207 = global_3.member[bitcast<u32>(select(0i, _e4201, (_e4201 > 0i)))];
let _e4208 = (_e3989 + 6i);
let _e4210 = select(_e3995, _e4208, (_e4208 < _e3995));
let _e4216 = global_3.member[bitcast<u32>(select(0i, _e4210, (_e4210 > 0i)))];
let _e4217 = (_e3989 + 1026i);
let _e4219 = select(_e3995, _e4217, (_e4217 < _e3995));
let _e4225 = global_3.member[bitcast<u32>(select(0i, _e4219, (_e4219 > 0i)))];
let _e4226 = (_e3989 + 1030i);
let _e4228 = select(_e3995, _e4226, (_e4226 < _e3995));
let _e4234 = global_3.member[bitcast<u32>(select(0i, _e4228, (_e4228 > 0i)))];
let _e4239 = (bitcast<f32>(((_e4207 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4247 = (_e4239 + (((bitcast<f32>(((_e4216 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4239) * _e3993));
let _e4252 = (bitcast<f32>(((_e4225 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4276 = (bitcast<f32>((((_e4207 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4284 = (_e4276 + (((bitcast<f32>((((_e4216 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4276) * _e3993));
let _e4289 = (bitcast<f32>((((_e4225 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4301 = (_e3989 + 3i);
let _e4303 = select(_e3995, _e4301, (_e4301 < _e3995));
let _e4309 = global_3.member[bitcast<u32>(select(0i, _e4303, (_e4303 > 0i)))];
let _e4310 = (_e3989 + 7i);
let _e4312 = select(_e3995, _e4310, (_e4310 < _e3995));
let _e4318 = global_3.member[bitcast<u32>(select(0i, _e4312, (_e4312 > 0i)))];
let _e4319 = (_e3989 + 1027i);
let _e4321 = select(_e3995, _e4319, (_e4319 < _e3995));
let _e4327 = global_3.member[bitcast<u32>(select(0i, _e4321, (_e4321 > 0i)))];
let _e4328 = (_e3989 + 1031i);
let _e4330 = select(_e3995, _e4328, (_e4328 < _e3995));
let _e4336 = global_3.member[bitcast<u32>(select(0i, _e4330, (_e4330 > 0i)))];
let _e4341 = (bitcast<f32>(((_e4309 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4349 = (_e4341 + (((bitcast<f32>(((_e4318 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4341) * _e3993));
let _e4354 = (bitcast<f32>(((_e4327 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4369 = (_e3645 * _e3540.member_1);
let _e4371 = -(((_e4080 + (((_e4085 + (((bitcast<f32>((((_e4030 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4085) * _e3993)) - _e4080) * _e3991)) * _e4369));
let _e4373 = select(-87f, _e4371, (_e4371 > -87f));
let _e4375 = select(88f, _e4373, (_e4373 < 88f));
let _e4377 = ((_e4375 * 1.442695f) + 0.5f);
let _e4379 = select(-127f, _e4377, (_e4377 > -127f));
let _e4381 = select(128f, _e4379, (_e4379 < 128f));
let _e4388 = select(0i, select(select(i32(_e4381), i32(-2147483648), (_e4381 < -2147483600f)), 2147483647i, (_e4381 > 2147483500f)), (_e4381 == _e4381));
let _e4392 = (_e4388 - select(0i, 1i, (_e4381 < f32(_e4388))));
let _e4393 = f32(_e4392);
let _e4397 = ((_e4375 - (_e4393 * 0.6933594f)) - (_e4393 * -2.1219444e-4f));
let _e4419 = -(((_e4145 + (((_e4150 + (((bitcast<f32>(((_e4132 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4150) * _e3993)) - _e4145) * _e3991)) * _e4369));
let _e4421 = select(-87f, _e4419, (_e4419 > -87f));
let _e4423 = select(88f, _e4421, (_e4421 < 88f));
let _e4425 = ((_e4423 * 1.442695f) + 0.5f);
let _e4427 = select(-127f, _e4425, (_e4425 > -127f));
let _e4429 = select(128f, _e4427, (_e4427 < 128f));
let _e4436 = select(0i, select(select(i32(_e4429), i32(-2147483648), (_e4429 < -2147483600f)), 2147483647i, (_e4429 > 2147483500f)), (_e4429 == _e4429));
let _e4440 = (_e4436 - select(0i, 1i, (_e4429 < f32(_e4436))));
let _e4441 = f32(_e4440);
let _e4445 = ((_e4423 - (_e4441 * 0.6933594f)) - (_e4441 * -2.1219444e-4f));
let _e4467 = -(((_e4182 + (((_e4187 + (((bitcast<f32>((((_e4132 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4187) * _e3993)) - _e4182) * _e3991)) * _e4369));
let _e4469 = select(-87f, _e4467, (_e4467 > -87f));
let _e4471 = select(88f, _e4469, (_e4469 < 88f));
let _e4473 = ((_e4471 * 1.442695f) + 0.5f);
let _e4475 = select(-127f, _e4473, (_e4473 > -127f));
let _e4477 = select(128f, _e4475, (_e4475 < 128f));
let _e4484 = select(0i, select(select(i32(_e4477), i32(-2147483648), (_e4477 < -2147483600f)), 2147483647i, (_e4477 > 2147483500f)), (_e4477 == _e4477));
let _e4488 = (_e4484 - select(0i, 1i, (_e4477 < f32(_e4484))));
let _e4489 = f32(_e4488);
let _e4493 = ((_e4471 - (_e4489 * 0.6933594f)) - (_e4489 * -2.1219444e-4f));
let _e4516 = -((_e4059 * (_e3645 * _e3540.member)));
let _e4518 = select(-87f, _e4516, (_e4516 > -87f));
let _e4520 = select(88f, _e4518, (_e4518 < 88f));
let _e4522 = ((_e4520 * 1.442695f) + 0.5f);
let _e4524 = select(-127f, _e4522, (_e4522 > -127f));
let _e4526 = select(128f, _e4524, (_e4524 < 128f));
let _e4533 = select(0i, select(select(i32(_e4526), i32(-2147483648), (_e4526 < -2147483600f)), 2147483647i, (_e4526 > 2147483500f)), (_e4526 == _e4526));
let _e4537 = (_e4533 - select(0i, 1i, (_e4526 < f32(_e4533))));
let _e4538 = f32(_e4537);
let _e4542 = ((_e4520 - (_e4538 * 0.6933594f)) - (_e4538 * -2.1219444e-4f));
let _e4562 = ((1f + (_e4542 * (1f + (_e4542 * (0.5f + (_e4542 * (0.16666667f + (_e4542 * (0.041666668f + (_e4542 * (0.008333334f + (_e4542 * (0.001388889f + (_e4542 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4537 + 127i)) << bitcast<u32>(23i))));
let _e4563 = (1f - _e4562);
let _e4566 = (_e4563 / select(1e-12f, _e4059, (_e4059 > 1e-12f)));
phi_8706_ = type_31(_e4562, _e4563, vec3<f32>(((1f + (_e4397 * (1f + (_e4397 * (0.5f + (_e4397 * (0.16666667f + (_e4397 * (0.041666668f + (_e4397 * (0.008333334f + (_e4397 * (0.001388889f + (_e4397 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4392 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4445 * (1f + (_e4445 * (0.5f + (_e4445 * (0.16666667f + (_e4445 * (0.041666668f + (_e4445 * (0.008333334f + (_e4445 * (0.001388889f + (_e4445 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4440 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4493 * (1f + (_e4493 * (0.5f + (_e4493 * (0.16666667f + (_e4493 * (0.041666668f + (_e4493 * (0.008333334f + (_e4493 * (0.001388889f + (_e4493 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4488 + 127i)) << bitcast<u32>(23i))))), vec3<f32>(((_e4247 + (((_e4252 + (((bitcast<f32>(((_e4234 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4252) * _e3993)) - _e4247) * _e3991)) * _e4566), ((_e4284 + (((_e4289 + (((bitcast<f32>((((_e4234 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4289) * _e3993)) - _e4284) * _e3991)) * _e4566), ((_e4349 + (((_e4354 + (((bitcast<f32>(((_e4336 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4354) * _e3993)) - _e4349) * _e3991)) * _e4566)));
}
let _e4573 = phi_8706_;
let _e4574 = select(0f, _e3327, _e451);
let _e4578 = (_e387 + (_e3627 * _e4574));
let _e4579 = (_e389 + (_e3628 * _e4574));
let _e4580 = (_e383 + (_e3629 * _e4574));
if (_e973.member_2 == 3u) {
let _e4586 = global_5.member[_e359].member_9.member_1;
let _e4595 = global_5.member[_e359].member_9.member;
phi_9689_ = type_25(vec3<f32>(_e4586.member, _e4586.member_1, _e4586.member_2), vec3<f32>(_e4595.member, _e4595.member_1, _e4595.member_2));
} else {
let _e4605 = global_5.member[_e359].member_8.member_8;
let _e4606 = (_e4580 - _e4605);
let _e4611 = global_5.member[_e359].member_8.member_2;
let _e4616 = global_5.member[_e359].member_8.member_6;
let _e4624 = global_5.member[_e359].member_8.member_5;
let _e4626 = (((_e4578 - (_e4611 + (_e4616 * _e4606))) * _e4624) - 0.5f);
let _e4631 = global_5.member[_e359].member_8.member_3;
let _e4636 = global_5.member[_e359].member_8.member_7;
let _e4641 = (((_e4579 - (_e4631 + (_e4636 * _e4606))) * _e4624) - 0.5f);
let _e4646 = global_5.member[_e359].member_8.member;
let _e4647 = bitcast<i32>(_e4646);
let _e4649 = (f32(_e4647) - 1f);
let _e4654 = global_5.member[_e359].member_8.member_1;
let _e4657 = (f32(bitcast<i32>(_e4654)) - 1f);
let _e4659 = select(0f, _e4626, (_e4626 > 0f));
let _e4661 = select(_e4649, _e4659, (_e4659 < _e4649));
let _e4668 = select(0i, select(select(i32(_e4661), i32(-2147483648), (_e4661 < -2147483600f)), 2147483647i, (_e4661 > 2147483500f)), (_e4661 == _e4661));
let _e4672 = (_e4668 - select(0i, 1i, (_e4661 < f32(_e4668))));
let _e4674 = select(0f, _e4641, (_e4641 > 0f));
let _e4676 = select(_e4657, _e4674, (_e4674 < _e4657));
let _e4683 = select(0i, select(select(i32(_e4676), i32(-2147483648), (_e4676 < -2147483600f)), 2147483647i, (_e4676 > 2147483500f)), (_e4676 == _e4676));
let _e4687 = (_e4683 - select(0i, 1i, (_e4676 < f32(_e4683))));
let _e4691 = (_e4626 - f32(_e4672));
let _e4693 = (_e4641 - f32(_e4687));
let _e4700 = ((((_e4626 >= 0f) && (_e4626 <= _e4649)) && (_e4641 >= 0f)) && (_e4641 <= _e4657));
let _e4704 = global_5.member[_e359].member_4;
let _e4705 = bitcast<i32>(_e4704);
let _e4707 = bitcast<i32>((_e4646 * _e4654));
let _e4709 = (_e4705 + (3i * _e4707));
local_1 = (_e4709 + ((_e4687 * _e4647) + _e4672));
let _e4711 = local_1;
let _e4713 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e4715 = select(_e4713, _e4711, (_e4711 < _e4713));
let _e4720 = global_6.member[bitcast<u32>(select(0i, _e4715, (_e4715 > 0i)))];
let _e4721 = bitcast<u32>(_e4720);
let _e4725 = f32((bitcast<i32>((_e4721 & 65535u)) - 32768i));
let _e4731 = f32((bitcast<i32>(((_e4721 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4736 = select(_e4731, -(_e4731), ((_e4721 >> bitcast<u32>(31i)) != 0u));
let _e4737 = local_1;
let _e4738 = (_e4737 + 1i);
let _e4740 = select(_e4713, _e4738, (_e4738 < _e4713));
let _e4745 = global_6.member[bitcast<u32>(select(0i, _e4740, (_e4740 > 0i)))];
let _e4746 = bitcast<u32>(_e4745);
let _e4756 = f32((bitcast<i32>(((_e4746 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4762 = local_1;
let _e4763 = (_e4762 + _e4647);
let _e4765 = select(_e4713, _e4763, (_e4763 < _e4713));
let _e4770 = global_6.member[bitcast<u32>(select(0i, _e4765, (_e4765 > 0i)))];
let _e4771 = bitcast<u32>(_e4770);
let _e4775 = f32((bitcast<i32>((_e4771 & 65535u)) - 32768i));
let _e4781 = f32((bitcast<i32>(((_e4771 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4786 = select(_e4781, -(_e4781), ((_e4771 >> bitcast<u32>(31i)) != 0u));
let _e4787 = (_e4647 + 1i);
let _e4788 = local_1;
let _e4789 = (_e4788 + _e4787);
let _e4791 = select(_e4713, _e4789, (_e4789 < _e4713));
let _e4796 = global_6.member[bitcast<u32>(select(0i, _e4791, (_e4791 > 0i)))];
let _e4797 = bitcast<u32>(_e4796);
let _e4807 = f32((bitcast<i32>(((_e4797 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4815 = (_e4725 + ((f32((bitcast<i32>((_e4746 & 65535u)) - 32768i)) - _e4725) * _e4691));
let _e4824 = (_e4736 + ((select(_e4756, -(_e4756), ((_e4746 >> bitcast<u32>(31i)) != 0u)) - _e4736) * _e4691));
let _e4837 = global_5.member[_e359].member_9.member;
let _e4840 = (1f / 16255f);
let _e4842 = (_e4837.member + (select(0f, (_e4815 + (((_e4775 + ((f32((bitcast<i32>((_e4797 & 65535u)) - 32768i)) - _e4775) * _e4691)) - _e4815) * _e4693)), _e4700) * _e4840));
let _e4844 = (_e4837.member_1 + (select(0f, (_e4824 + (((_e4786 + ((select(_e4807, -(_e4807), ((_e4797 >> bitcast<u32>(31i)) != 0u)) - _e4786) * _e4691)) - _e4824) * _e4693)), _e4700) * _e4840));
let _e4848 = (1f - ((_e4842 * _e4842) + (_e4844 * _e4844)));
let _e4850 = select(1e-4f, _e4848, (_e4848 > 1e-4f));
let _e4853 = sqrt(select(0f, _e4850, (_e4850 > 0f)));
let _e4857 = (1f / select(1e-6f, _e4853, (_e4853 > 1e-6f)));
let _e4858 = ((_e4580 - _e383) * _e4624);
let _e4865 = (_e4626 - (((_e4842 * _e4857) - _e4616) * _e4858));
let _e4866 = (_e4641 - (((_e4844 * _e4857) - _e4636) * _e4858));
let _e4868 = select(0f, _e4865, (_e4865 > 0f));
let _e4870 = select(_e4649, _e4868, (_e4868 < _e4649));
let _e4877 = select(0i, select(select(i32(_e4870), i32(-2147483648), (_e4870 < -2147483600f)), 2147483647i, (_e4870 > 2147483500f)), (_e4870 == _e4870));
let _e4881 = (_e4877 - select(0i, 1i, (_e4870 < f32(_e4877))));
let _e4883 = select(0f, _e4866, (_e4866 > 0f));
let _e4885 = select(_e4657, _e4883, (_e4883 < _e4657));
let _e4892 = select(0i, select(select(i32(_e4885), i32(-2147483648), (_e4885 < -2147483600f)), 2147483647i, (_e4885 > 2147483500f)), (_e4885 == _e4885));
let _e4896 = (_e4892 - select(0i, 1i, (_e4885 < f32(_e4892))));
let _e4898 = ((_e4896 * _e4647) + _e4881);
let _e4900 = (_e4865 - f32(_e4881));
let _e4902 = (_e4866 - f32(_e4896));
let _e4909 = ((((_e4865 >= 0f) && (_e4865 <= _e4649)) && (_e4866 >= 0f)) && (_e4866 <= _e4657));
let _e4910 = (_e4705 + _e4898);
let _e4912 = select(_e4713, _e4910, (_e4910 < _e4713));
let _e4918 = global_6.member[bitcast<u32>(select(0i, _e4912, (_e4912 > 0i)))];
let _e4919 = (_e4910 + 1i);
let _e4921 = select(_e4713, _e4919, (_e4919 < _e4713));
let _e4927 = global_6.member[bitcast<u32>(select(0i, _e4921, (_e4921 > 0i)))];
let _e4930 = (_e4918 + ((_e4927 - _e4918) * _e4900));
let _e4931 = (_e4910 + _e4647);
let _e4933 = select(_e4713, _e4931, (_e4931 < _e4713));
let _e4939 = global_6.member[bitcast<u32>(select(0i, _e4933, (_e4933 > 0i)))];
let _e4940 = (_e4931 + 1i);
let _e4942 = select(_e4713, _e4940, (_e4940 < _e4713));
let _e4948 = global_6.member[bitcast<u32>(select(0i, _e4942, (_e4942 > 0i)))];
let _e4955 = select(1f, (_e4930 + (((_e4939 + ((_e4948 - _e4939) * _e4900)) - _e4930) * _e4902)), _e4909);
if _e3646 {
phi_9459_ = vec3(_e4955);
} else {
let _e4958 = ((_e4705 + _e4707) + _e4898);
let _e4960 = select(_e4713, _e4958, (_e4958 < _e4713));
let _e4966 = global_6.member[bitcast<u32>(select(0i, _e4960, (_e4960 > 0i)))];
let _e4967 = (_e4958 + 1i);
let _e4969 = select(_e4713, _e4967, (_e4967 < _e4713));
let _e4975 = global_6.member[bitcast<u32>(select(0i, _e4969, (_e4969 > 0i)))];
let _e4978 = (_e4966 + ((_e4975 - _e4966) * _e4900));
let _e4979 = (_e4958 + _e4647);
let _e4981 = select(_e4713, _e4979, (_e4979 < _e4713));
let _e4987 = global_6.member[bitcast<u32>(select(0i, _e4981, (_e4981 > 0i)))];
let _e4988 = (_e4979 + 1i);
let _e4990 = select(_e4713, _e4988, (_e4988 < _e4713));
let _e4996 = global_6.member[bitcast<u32>(select(0i, _e4990, (_e4990 > 0i)))];
let _e5006 = ((_e4705 + (2i * _e4707)) + _e4898);
let _e5008 = select(_e4713, _e5006, (_e5006 < _e4713));
let _e5014 = global_6.member[bitcast<u32>(select(0i, _e5008, (_e5008 > 0i)))];
let _e5015 = (_e5006 + 1i);
let _e5017 = select(_e4713, _e5015, (_e5015 < _e4713));
let _e5023 = global_6.member[bitcast<u32>(select(0i, _e5017, (_e5017 > 0i)))];
let _e5026 = (_e5014 + ((_e5023 - _e5014) * _e4900));
let _e5027 = (_e5006 + _e4647);
let _e5029 = select(_e4713, _e5027, (_e5027 < _e4713));
let _e5035 = global_6.member[bitcast<u32>(select(0i, _e5029, (_e5029 > 0i)))];
let _e5036 = (_e5027 + 1i);
let _e5038 = select(_e4713, _e5036, (_e5036 < _e4713));
let _e5044 = global_6.member[bitcast<u32>(select(0i, _e5038, (_e5038 > 0i)))];
phi_9459_ = vec3<f32>(_e4955, select(1f, (_e4978 + (((_e4987 + ((_e4996 - _e4987) * _e4900)) - _e4978) * _e4902)), _e4909), select(1f, (_e5026 + (((_e5035 + ((_e5044 - _e5035) * _e4900)) - _e5026) * _e4902)), _e4909));
}
let _e5054 = phi_9459_;
local = (_e4709 + _e4898);
let _e5056 = local;
let _e5058 = select(_e4713, _e5056, (_e5056 < _e4713));
let _e5063 = global_6.member[bitcast<u32>(select(0i, _e5058, (_e5058 > 0i)))];
let _e5064 = bitcast<u32>(_e5063);
let _e5068 = f32((bitcast<i32>((_e5064 & 65535u)) - 32768i));
let _e5074 = f32((bitcast<i32>(((_e5064 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5079 = select(_e5074, -(_e5074), ((_e5064 >> bitcast<u32>(31i)) != 0u));
let _e5080 = local;
let _e5081 = (_e5080 + 1i);
let _e5083 = select(_e4713, _e5081, (_e5081 < _e4713));
let _e5088 = global_6.member[bitcast<u32>(select(0i, _e5083, (_e5083 > 0i)))];
let _e5089 = bitcast<u32>(_e5088);
let _e5099 = f32((bitcast<i32>(((_e5089 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5105 = local;
let _e5106 = (_e5105 + _e4647);
let _e5108 = select(_e4713, _e5106, (_e5106 < _e4713));
let _e5113 = global_6.member[bitcast<u32>(select(0i, _e5108, (_e5108 > 0i)))];
let _e5114 = bitcast<u32>(_e5113);
let _e5118 = f32((bitcast<i32>((_e5114 & 65535u)) - 32768i));
let _e5124 = f32((bitcast<i32>(((_e5114 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5129 = select(_e5124, -(_e5124), ((_e5114 >> bitcast<u32>(31i)) != 0u));
let _e5130 = local;
let _e5131 = (_e5130 + _e4787);
let _e5133 = select(_e4713, _e5131, (_e5131 < _e4713));
let _e5138 = global_6.member[bitcast<u32>(select(0i, _e5133, (_e5133 > 0i)))];
let _e5139 = bitcast<u32>(_e5138);
let _e5149 = f32((bitcast<i32>(((_e5139 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5157 = (_e5068 + ((f32((bitcast<i32>((_e5089 & 65535u)) - 32768i)) - _e5068) * _e4900));
let _e5166 = (_e5079 + ((select(_e5099, -(_e5099), ((_e5089 >> bitcast<u32>(31i)) != 0u)) - _e5079) * _e4900));
let _e5179 = global_5.member[_e359].member_9.member_1;
let _e5186 = (_e4837.member + (select(0f, (_e5157 + (((_e5118 + ((f32((bitcast<i32>((_e5139 & 65535u)) - 32768i)) - _e5118) * _e4900)) - _e5157) * _e4902)), _e4909) * _e4840));
let _e5188 = (_e4837.member_1 + (select(0f, (_e5166 + (((_e5129 + ((select(_e5149, -(_e5149), ((_e5139 >> bitcast<u32>(31i)) != 0u)) - _e5129) * _e4900)) - _e5166) * _e4902)), _e4909) * _e4840));
let _e5192 = (1f - ((_e5186 * _e5186) + (_e5188 * _e5188)));
let _e5194 = select(1e-4f, _e5192, (_e5192 > 1e-4f));
phi_9689_ = type_25((_e5054 * vec3<f32>(_e5179.member, _e5179.member_1, _e5179.member_2)), vec3<f32>(_e5186, _e5188, sqrt(select(0f, _e5194, (_e5194 > 0f)))));
}
let _e5201 = phi_9689_;
let _e5210 = (((_e5201.member_1.x * _e5201.member_1.x) + (_e5201.member_1.y * _e5201.member_1.y)) + (_e5201.member_1.z * _e5201.member_1.z));
let _e5213 = sqrt(select(0f, _e5210, (_e5210 > 0f)));
let _e5219 = (1e-6f * _e5213);
let _e5223 = select((_e5213 / select(_e5219, _e5201.member_1.z, (_e5201.member_1.z > _e5219))), 1f, ((_e931 & 8u) != 0u));
let _e5225 = (_e5201.member.x * _e5223);
let _e5227 = (_e5201.member.y * _e5223);
let _e5229 = (_e5201.member.z * _e5223);
if _e1047 {
let _e5234 = global_5.member[_e359].member_19;
let _e5243 = (((_e2726.member_1.x * _e2726.member_1.x) + (_e2726.member_1.y * _e2726.member_1.y)) + (_e2726.member_1.z * _e2726.member_1.z));
let _e5246 = sqrt(select(0f, _e5243, (_e5243 > 0f)));
let _e5249 = (1f / select(1e-20f, _e5246, (_e5246 > 1e-20f)));
let _e5250 = (_e2726.member_1.x * _e5249);
let _e5251 = (_e2726.member_1.y * _e5249);
let _e5252 = (_e2726.member_1.z * _e5249);
let _e5255 = (-1f / select(1e-20f, _e5213, (_e5213 > 1e-20f)));
let _e5256 = (_e5201.member_1.x * _e5255);
let _e5257 = (_e5201.member_1.y * _e5255);
let _e5258 = (_e5201.member_1.z * _e5255);
let _e5263 = (((_e363[3] * _e363[3]) + (_e363[4] * _e363[4])) + (_e363[5] * _e363[5]));
let _e5266 = sqrt(select(0f, _e5263, (_e5263 > 0f)));
let _e5269 = (-1f / select(1e-20f, _e5266, (_e5266 > 1e-20f)));
let _e5270 = (_e363[3] * _e5269);
let _e5271 = (_e363[4] * _e5269);
let _e5272 = (_e363[5] * _e5269);
let _e5279 = select(1f, -1f, ((((_e5250 * _e5270) + (_e5251 * _e5271)) + (_e5252 * _e5272)) < 0f));
let _e5280 = (_e5250 * _e5279);
let _e5281 = (_e5251 * _e5279);
let _e5282 = (_e5252 * _e5279);
let _e5287 = (((_e5280 * _e5270) + (_e5281 * _e5271)) + (_e5282 * _e5272));
let _e5289 = select(1e-4f, _e5287, (_e5287 > 1e-4f));
let _e5294 = (((_e5280 * _e5256) + (_e5281 * _e5257)) + (_e5282 * _e5258));
let _e5295 = (_e5256 + _e5270);
let _e5296 = (_e5257 + _e5271);
let _e5297 = (_e5258 + _e5272);
let _e5302 = (((_e5295 * _e5295) + (_e5296 * _e5296)) + (_e5297 * _e5297));
let _e5305 = sqrt(select(0f, _e5302, (_e5302 > 0f)));
let _e5308 = (1f / select(1e-6f, _e5305, (_e5305 > 1e-6f)));
let _e5309 = (_e5295 * _e5308);
let _e5310 = (_e5296 * _e5308);
let _e5311 = (_e5297 * _e5308);
let _e5316 = (((_e5280 * _e5309) + (_e5281 * _e5310)) + (_e5282 * _e5311));
let _e5318 = select(0f, _e5316, (_e5316 > 0f));
let _e5323 = (((_e5270 * _e5309) + (_e5271 * _e5310)) + (_e5272 * _e5311));
let _e5325 = select(0f, _e5323, (_e5323 > 0f));
let _e5326 = (_e5234 * _e5234);
let _e5327 = (_e5326 * _e5326);
let _e5331 = (((_e5318 * _e5318) * (_e5327 - 1f)) + 1f);
let _e5335 = (_e5294 > 0f);
let _e5336 = select(0f, _e5294, _e5335);
let _e5338 = (1f - _e5327);
let _e5340 = (((_e5336 * _e5336) * _e5338) + _e5327);
let _e5347 = (((_e5289 * _e5289) * _e5338) + _e5327);
let _e5352 = ((_e5289 * sqrt(select(0f, _e5340, (_e5340 > 0f)))) + (_e5336 * sqrt(select(0f, _e5347, (_e5347 > 0f)))));
let _e5357 = (_e2726.member_2 / _e3324);
let _e5361 = (((_e5357 * _e5357) - 1f) + (_e5325 * _e5325));
let _e5364 = sqrt(select(0f, _e5361, (_e5361 > 0f)));
let _e5365 = (_e5364 - _e5325);
let _e5366 = (_e5364 + _e5325);
let _e5369 = (_e5365 / select(1e-6f, _e5366, (_e5366 > 1e-6f)));
let _e5373 = ((_e5325 * _e5365) + 1f);
let _e5376 = (((_e5325 * _e5366) - 1f) / select(1e-6f, _e5373, (_e5373 > 1e-6f)));
let _e5394 = global_5.member[_e359].member_20;
let _e5398 = ((select(0f, ((((_e5327 / ((3.1415927f * _e5331) * _e5331)) * (0.5f / select(1e-6f, _e5352, (_e5352 > 1e-6f)))) * select(select((((0.5f * _e5369) * _e5369) * (1f + (_e5376 * _e5376))), 1f, (_e5361 <= 0f)), 0f, (_e3324 == _e2726.member_2))) * _e5336), (_e5335 && (_e5246 > 1e-12f))) * _e5394) * select(_e3540.member_2, 0f, _e451));
phi_10007_ = vec3<f32>((_e5225 * _e5398), (_e5227 * _e5398), (_e5229 * _e5398));
} else {
phi_10007_ = vec3<f32>(0f, 0f, 0f);
}
let _e5404 = phi_10007_;
let _e5408 = global_5.member[_e359].member_18;
let _e5415 = (1f - _e363[12]);
let _e5435 = (_e363[9] + ((_e363[13] * ((_e4573.member_3.x * (_e5225 + _e5408.member)) + _e5404.x)) * _e5415));
let _e5436 = (_e363[10] + ((_e363[14] * ((_e4573.member_3.y * (_e5227 + _e5408.member_1)) + _e5404.y)) * _e5415));
let _e5437 = (_e363[11] + ((_e363[15] * ((_e4573.member_3.z * (_e5229 + _e5408.member_2)) + _e5404.z)) * _e5415));
let _e5440 = (_e363[12] + (_e5415 * _e4573.member_1));
let _e5443 = (_e363[13] * _e4573.member_2.x);
let _e5445 = (_e363[14] * _e4573.member_2.y);
let _e5447 = (_e363[15] * _e4573.member_2.z);
let _e5452 = (_e363[8] + ((_e5440 - _e363[12]) * (_e383 + (_e3629 * 0.5f))));
let _e5461 = (-((((select(_e1017.member, _e1004.member, _e997) * _e5201.member_1.x) + (select(_e1017.member_1, _e1004.member_1, _e997) * _e5201.member_1.y)) + (select(_e1017.member_2, _e1004.member_2, _e997) * _e5201.member_1.z))) / select(1e-20f, _e5213, (_e5213 > 1e-20f)));
let _e5466 = bitcast<f32>((bitcast<u32>(select(0f, _e5461, (_e5461 > 0f))) & 2147483647u));
let _e5476 = (1f - _e5440);
let _e5489 = select(_e5440, 1f, _e451);
if _e1047 {
let _e5498 = global_5.member[_e359].member_5.member_4;
let _e5501 = (_e2726.member_3.x * _e3540.member_2);
let _e5503 = (_e2726.member_3.y * _e3540.member_2);
let _e5505 = (_e2726.member_3.z * _e3540.member_2);
let _e5506 = (0.5f * _e378);
let _e5510 = (_e363[3] + (_e5501 * _e5506));
let _e5511 = (_e363[4] + (_e5503 * _e5506));
let _e5512 = (_e363[5] + (_e5505 * _e5506));
let _e5514 = (2f * _e377);
let _e5516 = ((_e5512 * _e5512) + (_e5514 * _e5505));
let _e5520 = (_e5512 + sqrt(select(0f, _e5516, (_e5516 > 0f))));
let _e5524 = (0.5f * (_e5514 / select(1e-6f, _e5520, (_e5520 > 1e-6f))));
let _e5528 = (_e5510 + (_e5501 * _e5524));
let _e5529 = (_e5511 + (_e5503 * _e5524));
let _e5530 = (_e5512 + (_e5505 * _e5524));
let _e5534 = (_e5498 * _e5498);
let _e5536 = (_e5530 * _e5530);
let _e5544 = (((_e5512 <= 0f) || (_e5516 <= 0f)) || ((_e5530 <= 0f) || (_e5536 <= (_e5534 * (((_e5528 * _e5528) + (_e5529 * _e5529)) + _e5536)))));
let _e5558 = (_e363[3] + ((_e2726.member_4.x * _e3540.member_2) * _e377));
let _e5559 = (_e363[4] + ((_e2726.member_4.y * _e3540.member_2) * _e377));
let _e5560 = (_e363[5] + ((_e2726.member_4.z * _e3540.member_2) * _e377));
let _e5562 = (_e5560 * _e5560);
let _e5571 = ((_e931 & 1u) != 0u);
phi_10312_ = vec3<f32>(select(select(_e5528, _e5510, _e5544), _e5558, _e5571), select(select(_e5529, _e5511, _e5544), _e5559, _e5571), select(select(_e5530, _e5512, _e5544), _e5560, _e5571));
phi_10313_ = select(_e5544, ((_e5560 <= 0f) || (_e5562 <= (_e5534 * (((_e5558 * _e5558) + (_e5559 * _e5559)) + _e5562)))), _e5571);
} else {
phi_10312_ = vec3<f32>(_e363[3], _e363[4], _e363[5]);
phi_10313_ = false;
}
let _e5578 = phi_10312_;
let _e5580 = phi_10313_;
let _e5589 = (((_e451 || (_e5578.x != _e363[3])) || (_e5578.y != _e363[4])) || (_e5578.z != _e363[5]));
let _e5591 = select(_e5445, _e5443, (_e5443 > _e5445));
phi_10378_ = array<f32, 18>(select(_e363[0], select(_e391, _e4578, _e451), _e5589), select(_e363[1], select(_e393, _e4579, _e451), _e5589), select(_e363[2], select(_e398, _e4580, _e451), _e5589), _e5578.x, _e5578.y, _e5578.z, _e2726.member, select(select(0f, 2f, _e5580), 1f, (_e451 || (((1f - _e5489) * select(_e5447, _e5591, (_e5591 > _e5447))) < 9.765625e-4f))), select(_e5452, (_e5452 + (_e5476 * _e4580)), _e451), select(_e5435, (_e5435 + ((_e5443 * (select(_e1023.member, _e1010.member, _e997) * ((_e5225 * _e5466) + _e5408.member))) * _e5476)), _e451), select(_e5436, (_e5436 + ((_e5445 * (select(_e1023.member_1, _e1010.member_1, _e997) * ((_e5227 * _e5466) + _e5408.member_1))) * _e5476)), _e451), select(_e5437, (_e5437 + ((_e5447 * (select(_e1023.member_2, _e1010.member_2, _e997) * ((_e5229 * _e5466) + _e5408.member_2))) * _e5476)), _e451), _e5489, _e5443, _e5445, _e5447, _e2726.member_2, _e398);
} else {
phi_10378_ = _e363;
}
let _e5610 = phi_10378_;
phi_589_ = (_e359 + 1u);
phi_592_ = select(_e361, true, _e969);
phi_594_ = _e5610;
} else {
phi_589_ = u32();
phi_592_ = bool();
phi_594_ = array<f32, 18>();
}
let _e5614 = phi_589_;
let _e5616 = phi_592_;
let _e5618 = phi_594_;
continue;
continuing {
phi_588_ = _e5614;
phi_591_ = _e5616;
phi_593_ = _e5618;
phi_10461_ = false;
break if !(_e364);
}
}
let _e5621 = phi_10461_;
if _e5621 {
break;
}
let _e5623 = local_12;
if _e5623 {
let _e5625 = local_13;
global_4.member[_e159] = _e5625[0];
let _e5630 = local_14;
global_4.member[_e171] = _e5630[1];
let _e5635 = local_15;
global_4.member[_e182] = _e5635[2];
let _e5640 = local_16;
global_4.member[_e193] = _e5640[3];
let _e5645 = local_17;
global_4.member[_e204] = _e5645[4];
let _e5650 = local_18;
global_4.member[_e215] = _e5650[5];
let _e5655 = local_19;
global_4.member[_e226] = _e5655[6];
let _e5660 = local_20;
global_4.member[_e237] = _e5660[7];
let _e5665 = local_21;
global_4.member[_e248] = _e5665[8];
let _e5670 = local_22;
global_4.member[_e259] = _e5670[9];
let _e5675 = local_23;
global_4.member[_e270] = _e5675[10];
let _e5680 = local_24;
global_4.member[_e281] = _e5680[11];
let _e5685 = local_25;
global_4.member[_e292] = _e5685[12];
let _e5690 = local_26;
global_4.member[_e303] = _e5690[13];
let _e5695 = local_27;
global_4.member[_e314] = _e5695[14];
let _e5700 = local_28;
global_4.member[_e325] = _e5700[15];
let _e5705 = local_29;
global_4.member[_e336] = _e5705[16];
let _e5710 = local_30;
global_4.member[_e347] = _e5710[17];
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
