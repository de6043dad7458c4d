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
member: type_24,
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
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(3)
var<storage> global_3: type_16;
@group(0) @binding(4)
var<storage> global_4: type_16;
@group(0) @binding(6)
var<storage, read_write> global_5: type_11;
@group(0) @binding(5)
var<storage> global_6: type_11;
fn function_() {
var local: type_28;
var local_1: vec3<f32>;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var phi_942_: u32;
var phi_3503_: type_29;
var phi_4204_: type_30;
var phi_5092_: type_5;
var phi_6202_: type_31;
var phi_6353_: f32;
var phi_6354_: f32;
var phi_6355_: f32;
var phi_6356_: f32;
let _e86 = global;
let _e89 = arrayLength((&global_2.member));
let _e93 = arrayLength((&global_4.member));
let _e95 = arrayLength((&global_6.member));
let _e100 = global_1.member.member_2;
let _e103 = global_1.member.member;
let _e111 = (_e86.x + _e100.member);
let _e113 = (_e86.y + _e100.member_1);
if (_e111 < _e100.member_2) {
if (_e113 < _e100.member_3) {
let _e116 = (_e103.member * _e103.member_1);
let _e118 = ((_e113 * _e103.member) + _e111);
let _e119 = bitcast<i32>(_e118);
let _e121 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e123 = select(_e121, _e119, (_e119 < _e121));
let _e129 = global_5.member[bitcast<u32>(select(0i, _e123, (_e123 > 0i)))];
let _e130 = (_e116 + _e118);
let _e131 = bitcast<i32>(_e130);
let _e133 = select(_e121, _e131, (_e131 < _e121));
let _e139 = global_5.member[bitcast<u32>(select(0i, _e133, (_e133 > 0i)))];
let _e141 = ((2u * _e116) + _e118);
let _e142 = bitcast<i32>(_e141);
let _e144 = select(_e121, _e142, (_e142 < _e121));
let _e150 = global_5.member[bitcast<u32>(select(0i, _e144, (_e144 > 0i)))];
let _e152 = ((3u * _e116) + _e118);
let _e153 = bitcast<i32>(_e152);
let _e155 = select(_e121, _e153, (_e153 < _e121));
let _e161 = global_5.member[bitcast<u32>(select(0i, _e155, (_e155 > 0i)))];
let _e163 = ((4u * _e116) + _e118);
let _e164 = bitcast<i32>(_e163);
let _e166 = select(_e121, _e164, (_e164 < _e121));
let _e172 = global_5.member[bitcast<u32>(select(0i, _e166, (_e166 > 0i)))];
let _e174 = ((5u * _e116) + _e118);
let _e175 = bitcast<i32>(_e174);
let _e177 = select(_e121, _e175, (_e175 < _e121));
let _e183 = global_5.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e185 = ((6u * _e116) + _e118);
let _e186 = bitcast<i32>(_e185);
let _e188 = select(_e121, _e186, (_e186 < _e121));
let _e194 = global_5.member[bitcast<u32>(select(0i, _e188, (_e188 > 0i)))];
let _e196 = ((7u * _e116) + _e118);
let _e197 = bitcast<i32>(_e196);
let _e199 = select(_e121, _e197, (_e197 < _e121));
let _e205 = global_5.member[bitcast<u32>(select(0i, _e199, (_e199 > 0i)))];
let _e207 = ((8u * _e116) + _e118);
let _e208 = bitcast<i32>(_e207);
let _e210 = select(_e121, _e208, (_e208 < _e121));
let _e216 = global_5.member[bitcast<u32>(select(0i, _e210, (_e210 > 0i)))];
let _e220 = global_1.member.member_8.member;
let _e224 = global_1.member.member_8.member_1;
let _e225 = (_e220 * _e224);
if (_e95 >= (_e225 * 2u)) {
let _e229 = bitcast<i32>((_e113 * _e220));
let _e231 = bitcast<i32>(_e111);
let _e236 = global_6.member[bitcast<u32>((_e229 + _e231))];
let _e242 = global_6.member[bitcast<u32>(((bitcast<i32>(_e225) + _e229) + _e231))];
let _e243 = f32(_e231);
let _e245 = f32(bitcast<i32>(_e113));
let _e251 = global_1.member.member_5.member;
let _e255 = global_1.member.member_8.member_8;
let _e256 = (_e251 - _e255);
let _e260 = global_1.member.member_8.member_2;
let _e264 = global_1.member.member_8.member_6;
let _e271 = global_1.member.member_8.member_4;
let _e273 = ((_e260 + (_e264 * _e256)) + (((_e243 - _e236) + 0.5f) * _e271));
let _e277 = global_1.member.member_8.member_3;
let _e281 = global_1.member.member_8.member_7;
let _e286 = ((_e277 + (_e281 * _e256)) + (((_e245 - _e242) + 0.5f) * _e271));
let _e290 = global_1.member.member_5.member_1;
let _e291 = (_e290 - _e255);
let _e296 = ((_e260 + (_e264 * _e291)) + ((_e243 + 0.5f) * _e271));
let _e301 = ((_e277 + (_e281 * _e291)) + ((_e245 + 0.5f) * _e271));
let _e305 = global_1.member.member_6.member;
let _e316 = ((((_e305.member.member * _e273) + (_e305.member.member_1 * _e286)) + (_e305.member.member_2 * _e251)) + _e305.member_1);
let _e320 = global_1.member.member_6.member_1;
let _e331 = ((((_e320.member.member * _e273) + (_e320.member.member_1 * _e286)) + (_e320.member.member_2 * _e251)) + _e320.member_1);
let _e335 = global_1.member.member_6.member_2;
let _e346 = ((((_e335.member.member * _e273) + (_e335.member.member_1 * _e286)) + (_e335.member.member_2 * _e251)) + _e335.member_1);
let _e352 = ((((_e305.member.member * _e296) + (_e305.member.member_1 * _e301)) + (_e305.member.member_2 * _e290)) + _e305.member_1);
let _e358 = ((((_e320.member.member * _e296) + (_e320.member.member_1 * _e301)) + (_e320.member.member_2 * _e290)) + _e320.member_1);
let _e364 = ((((_e335.member.member * _e296) + (_e335.member.member_1 * _e301)) + (_e335.member.member_2 * _e290)) + _e335.member_1);
let _e370 = global_1.member.member_6.member_3.member;
let _e371 = (_e370 - 1f);
let _e380 = global_1.member.member_6.member_3.member_1;
let _e381 = (_e380 - 1f);
let _e390 = global_1.member.member_6.member_3.member_2;
let _e391 = (_e390 - 1f);
let _e410 = global_1.member.member_6.member_4;
let _e411 = (_e370 - 0.5f);
let _e413 = select(-0.5f, _e352, (_e352 > -0.5f));
let _e415 = select(_e411, _e413, (_e413 < _e411));
let _e416 = (_e380 - 0.5f);
let _e418 = select(-0.5f, _e358, (_e358 > -0.5f));
let _e420 = select(_e416, _e418, (_e418 < _e416));
let _e421 = (_e390 - 0.5f);
let _e423 = select(-0.5f, _e364, (_e364 > -0.5f));
let _e425 = select(_e421, _e423, (_e423 < _e421));
let _e431 = bitcast<f32>((bitcast<u32>((_e352 - _e316)) & 2147483647u));
let _e434 = bitcast<f32>((bitcast<u32>((_e358 - _e331)) & 2147483647u));
let _e436 = select(_e434, _e431, (_e431 > _e434));
let _e439 = bitcast<f32>((bitcast<u32>((_e364 - _e346)) & 2147483647u));
let _e448 = bitcast<f32>((bitcast<u32>((_e352 - _e415)) & 2147483647u));
let _e451 = bitcast<f32>((bitcast<u32>((_e358 - _e420)) & 2147483647u));
let _e453 = select(_e451, _e448, (_e448 > _e451));
let _e456 = bitcast<f32>((bitcast<u32>((_e364 - _e425)) & 2147483647u));
let _e460 = (_e415 + 0.5f);
let _e462 = select(0f, _e460, (_e460 > 0f));
let _e464 = select(_e371, _e462, (_e462 < _e371));
let _e471 = select(0i, select(select(i32(_e464), i32(-2147483648), (_e464 < -2147483600f)), 2147483647i, (_e464 > 2147483500f)), (_e464 == _e464));
let _e479 = global_1.member.member_6.member_12;
let _e480 = (_e479 & 31u);
let _e483 = (_e420 + 0.5f);
let _e485 = select(0f, _e483, (_e483 > 0f));
let _e487 = select(_e381, _e485, (_e485 < _e381));
let _e494 = select(0i, select(select(i32(_e487), i32(-2147483648), (_e487 < -2147483600f)), 2147483647i, (_e487 > 2147483500f)), (_e487 == _e487));
let _e501 = (_e425 + 0.5f);
let _e503 = select(0f, _e501, (_e501 > 0f));
let _e505 = select(_e391, _e503, (_e503 < _e391));
let _e512 = select(0i, select(select(i32(_e505), i32(-2147483648), (_e505 < -2147483600f)), 2147483647i, (_e505 > 2147483500f)), (_e505 == _e505));
let _e523 = global_1.member.member_6.member_9.member;
let _e529 = global_1.member.member_6.member_9.member_1;
let _e534 = global_1.member.member_6.member_10;
let _e540 = ((bitcast<i32>(_e534) + ((_e471 - select(0i, 1i, (_e464 < f32(_e471)))) >> bitcast<u32>(_e480))) + (bitcast<i32>(_e523) * (((_e494 - select(0i, 1i, (_e487 < f32(_e494)))) >> bitcast<u32>(_e480)) + (bitcast<i32>(_e529) * ((_e512 - select(0i, 1i, (_e505 < f32(_e512)))) >> bitcast<u32>(_e480))))));
let _e542 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e544 = select(_e542, _e540, (_e540 < _e542));
let _e550 = global_3.member[bitcast<u32>(select(0i, _e544, (_e544 > 0i)))];
let _e556 = global_1.member.member_1;
phi_942_ = select(select(7u, 3u, (((((((_e316 >= 0f) && (_e316 <= _e371)) && (_e331 >= 0f)) && (_e331 <= _e381)) && (_e346 >= 0f)) && (_e346 <= _e391)) && ((((((_e352 >= 0f) && (_e352 <= _e371)) && (_e358 >= 0f)) && (_e358 <= _e381)) && (_e364 >= 0f)) && (_e364 <= _e391)))), 1u, (((_e556 & 64u) != 0u) || ((((select(_e439, _e436, (_e436 > _e439)) <= _e410) && ((select(_e456, _e453, (_e453 > _e456)) > _e410) || (_e550 != 0u))) && true) && ((_e556 & 32u) != 0u))));
} else {
phi_942_ = 7u;
}
let _e566 = phi_942_;
if (_e566 > 1u) {
let _e571 = bitcast<i32>(((_e113 * _e220) + _e111));
let _e574 = (bitcast<i32>(_e95) - 1i);
let _e576 = select(_e574, _e571, (_e571 < _e574));
let _e582 = global_6.member[bitcast<u32>(select(0i, _e576, (_e576 > 0i)))];
let _e583 = (bitcast<i32>(_e225) + _e571);
let _e585 = select(_e574, _e583, (_e583 < _e574));
let _e591 = global_6.member[bitcast<u32>(select(0i, _e585, (_e585 > 0i)))];
let _e593 = f32(bitcast<i32>(_e111));
let _e595 = f32(bitcast<i32>(_e113));
let _e601 = global_1.member.member_5.member;
let _e605 = global_1.member.member_8.member_8;
let _e606 = (_e601 - _e605);
let _e610 = global_1.member.member_8.member_2;
let _e614 = global_1.member.member_8.member_6;
let _e621 = global_1.member.member_8.member_4;
let _e623 = ((_e610 + (_e614 * _e606)) + (((_e593 - _e582) + 0.5f) * _e621));
let _e627 = global_1.member.member_8.member_3;
let _e631 = global_1.member.member_8.member_7;
let _e636 = ((_e627 + (_e631 * _e606)) + (((_e595 - _e591) + 0.5f) * _e621));
let _e640 = global_1.member.member_5.member_1;
let _e641 = (_e640 - _e605);
let _e646 = ((_e610 + (_e614 * _e641)) + ((_e593 + 0.5f) * _e621));
let _e651 = ((_e627 + (_e631 * _e641)) + ((_e595 + 0.5f) * _e621));
let _e655 = global_1.member.member_6.member;
let _e666 = ((((_e655.member.member * _e623) + (_e655.member.member_1 * _e636)) + (_e655.member.member_2 * _e601)) + _e655.member_1);
let _e670 = global_1.member.member_6.member_1;
let _e681 = ((((_e670.member.member * _e623) + (_e670.member.member_1 * _e636)) + (_e670.member.member_2 * _e601)) + _e670.member_1);
let _e685 = global_1.member.member_6.member_2;
let _e696 = ((((_e685.member.member * _e623) + (_e685.member.member_1 * _e636)) + (_e685.member.member_2 * _e601)) + _e685.member_1);
let _e702 = ((((_e655.member.member * _e646) + (_e655.member.member_1 * _e651)) + (_e655.member.member_2 * _e640)) + _e655.member_1);
let _e708 = ((((_e670.member.member * _e646) + (_e670.member.member_1 * _e651)) + (_e670.member.member_2 * _e640)) + _e670.member_1);
let _e714 = ((((_e685.member.member * _e646) + (_e685.member.member_1 * _e651)) + (_e685.member.member_2 * _e640)) + _e685.member_1);
let _e716 = (_e103.member_2 == 2u);
let _e719 = (((_e103.member_2 == 1u) || _e716) || (_e103.member_2 == 5u));
if _e719 {
let _e724 = global_1.member.member_6.member_3.member;
let _e725 = (_e724 - 0.5f);
let _e727 = select(-0.5f, _e702, (_e702 > -0.5f));
let _e729 = select(_e725, _e727, (_e727 < _e725));
let _e734 = global_1.member.member_6.member_3.member_1;
let _e735 = (_e734 - 0.5f);
let _e737 = select(-0.5f, _e708, (_e708 > -0.5f));
let _e739 = select(_e735, _e737, (_e737 < _e735));
let _e744 = global_1.member.member_6.member_3.member_2;
let _e745 = (_e744 - 0.5f);
let _e747 = select(-0.5f, _e714, (_e714 > -0.5f));
let _e749 = select(_e745, _e747, (_e747 < _e745));
let _e751 = select(-1f, _e729, (_e729 > -1f));
let _e753 = select(_e724, _e751, (_e751 < _e724));
let _e760 = select(0i, select(select(i32(_e753), i32(-2147483648), (_e753 < -2147483600f)), 2147483647i, (_e753 > 2147483500f)), (_e753 == _e753));
let _e764 = (_e760 - select(0i, 1i, (_e753 < f32(_e760))));
let _e766 = select(-1f, _e739, (_e739 > -1f));
let _e768 = select(_e734, _e766, (_e766 < _e734));
let _e775 = select(0i, select(select(i32(_e768), i32(-2147483648), (_e768 < -2147483600f)), 2147483647i, (_e768 > 2147483500f)), (_e768 == _e768));
let _e779 = (_e775 - select(0i, 1i, (_e768 < f32(_e775))));
let _e781 = select(-1f, _e749, (_e749 > -1f));
let _e783 = select(_e744, _e781, (_e781 < _e744));
let _e790 = select(0i, select(select(i32(_e783), i32(-2147483648), (_e783 < -2147483600f)), 2147483647i, (_e783 > 2147483500f)), (_e783 == _e783));
let _e794 = (_e790 - select(0i, 1i, (_e783 < f32(_e790))));
let _e798 = global_1.member.member_6.member_7;
let _e802 = global_1.member.member_6.member_8;
let _e803 = (_e764 + 1i);
let _e804 = (_e779 + 1i);
let _e805 = (_e794 + 1i);
let _e810 = global_1.member.member_6.member_11.member;
let _e816 = global_1.member.member_6.member_11.member_1;
let _e827 = ((_e803 >> bitcast<u32>(4i)) + (bitcast<i32>(_e810) * ((_e804 >> bitcast<u32>(4i)) + (bitcast<i32>(_e816) * (_e805 >> bitcast<u32>(4i))))));
let _e829 = (bitcast<i32>(_e89) - 1i);
let _e831 = select(_e829, _e827, (_e827 < _e829));
let _e837 = global_2.member[bitcast<u32>(select(0i, _e831, (_e831 > 0i)))];
let _e839 = (_e803 & 15i);
let _e842 = ((_e804 & 15i) * _e798);
let _e844 = (bitcast<i32>(_e837) + ((_e805 & 15i) * _e802));
let _e848 = (_e842 + _e798);
let _e850 = (_e842 + (2i * _e798));
let _e852 = (_e842 + (3i * _e798));
let _e853 = (_e844 + _e802);
let _e855 = (_e844 + (2i * _e802));
let _e857 = (_e844 + (3i * _e802));
local_4 = type_28(array<i32, 4>(_e839, (_e839 + 1i), (_e839 + 2i), (_e839 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e729 - f32(_e764)), (_e739 - f32(_e779)), (_e749 - f32(_e794)));
let _e868 = (_e853 + _e848);
let _e871 = local_4.member[0u];
let _e872 = (_e868 + _e871);
let _e874 = (_e872 >> bitcast<u32>(1i));
let _e877 = bitcast<u32>(((_e872 & 1i) * 16i));
let _e879 = select(_e829, _e874, (_e874 < _e829));
let _e884 = global_2.member[bitcast<u32>(select(0i, _e879, (_e879 > 0i)))];
let _e888 = (_e874 + 1i);
let _e890 = select(_e829, _e888, (_e888 < _e829));
let _e895 = global_2.member[bitcast<u32>(select(0i, _e890, (_e890 > 0i)))];
let _e902 = ((_e884 >> bitcast<u32>((_e877 & 31u))) | ((_e895 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e877) & 31u))));
let _e905 = local_4.member[2u];
let _e906 = (_e868 + _e905);
let _e908 = (_e906 >> bitcast<u32>(1i));
let _e911 = bitcast<u32>(((_e906 & 1i) * 16i));
let _e913 = select(_e829, _e908, (_e908 < _e829));
let _e918 = global_2.member[bitcast<u32>(select(0i, _e913, (_e913 > 0i)))];
let _e922 = (_e908 + 1i);
let _e924 = select(_e829, _e922, (_e922 < _e829));
let _e929 = global_2.member[bitcast<u32>(select(0i, _e924, (_e924 > 0i)))];
let _e936 = ((_e918 >> bitcast<u32>((_e911 & 31u))) | ((_e929 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e911) & 31u))));
let _e939 = local_4.member_1[0u];
let _e945 = f32(bitcast<i32>(((_e902 >> bitcast<u32>((_e939 & 31u))) & 65535u)));
let _e948 = local_4.member_1[1u];
let _e954 = f32(bitcast<i32>(((_e902 >> bitcast<u32>((_e948 & 31u))) & 65535u)));
let _e957 = local_4.member_1[4u];
let _e963 = f32(bitcast<i32>(((_e936 >> bitcast<u32>((_e957 & 31u))) & 65535u)));
let _e966 = local_4.member_1[5u];
let _e973 = local_5[0u];
let _e976 = (_e945 + ((_e954 - _e945) * _e973));
let _e977 = local_5[0u];
let _e980 = (_e954 + ((_e963 - _e954) * _e977));
let _e981 = local_5[0u];
let _e984 = (_e963 + ((f32(bitcast<i32>(((_e936 >> bitcast<u32>((_e966 & 31u))) & 65535u))) - _e963) * _e981));
let _e985 = (_e853 + _e850);
let _e986 = local_4.member[0u];
let _e987 = (_e985 + _e986);
let _e989 = (_e987 >> bitcast<u32>(1i));
let _e992 = bitcast<u32>(((_e987 & 1i) * 16i));
let _e994 = select(_e829, _e989, (_e989 < _e829));
let _e999 = global_2.member[bitcast<u32>(select(0i, _e994, (_e994 > 0i)))];
let _e1003 = (_e989 + 1i);
let _e1005 = select(_e829, _e1003, (_e1003 < _e829));
let _e1010 = global_2.member[bitcast<u32>(select(0i, _e1005, (_e1005 > 0i)))];
let _e1017 = ((_e999 >> bitcast<u32>((_e992 & 31u))) | ((_e1010 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e992) & 31u))));
let _e1018 = local_4.member[2u];
let _e1019 = (_e985 + _e1018);
let _e1021 = (_e1019 >> bitcast<u32>(1i));
let _e1024 = bitcast<u32>(((_e1019 & 1i) * 16i));
let _e1026 = select(_e829, _e1021, (_e1021 < _e829));
let _e1031 = global_2.member[bitcast<u32>(select(0i, _e1026, (_e1026 > 0i)))];
let _e1035 = (_e1021 + 1i);
let _e1037 = select(_e829, _e1035, (_e1035 < _e829));
let _e1042 = global_2.member[bitcast<u32>(select(0i, _e1037, (_e1037 > 0i)))];
let _e1049 = ((_e1031 >> bitcast<u32>((_e1024 & 31u))) | ((_e1042 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1024) & 31u))));
let _e1050 = local_4.member_1[0u];
let _e1056 = f32(bitcast<i32>(((_e1017 >> bitcast<u32>((_e1050 & 31u))) & 65535u)));
let _e1057 = local_4.member_1[1u];
let _e1063 = f32(bitcast<i32>(((_e1017 >> bitcast<u32>((_e1057 & 31u))) & 65535u)));
let _e1064 = local_4.member_1[4u];
let _e1070 = f32(bitcast<i32>(((_e1049 >> bitcast<u32>((_e1064 & 31u))) & 65535u)));
let _e1071 = local_4.member_1[5u];
let _e1078 = local_5[0u];
let _e1082 = local_5[0u];
let _e1085 = (_e1063 + ((_e1070 - _e1063) * _e1082));
let _e1086 = local_5[0u];
let _e1090 = (_e855 + _e848);
let _e1091 = local_4.member[0u];
let _e1092 = (_e1090 + _e1091);
let _e1094 = (_e1092 >> bitcast<u32>(1i));
let _e1097 = bitcast<u32>(((_e1092 & 1i) * 16i));
let _e1099 = select(_e829, _e1094, (_e1094 < _e829));
let _e1104 = global_2.member[bitcast<u32>(select(0i, _e1099, (_e1099 > 0i)))];
let _e1108 = (_e1094 + 1i);
let _e1110 = select(_e829, _e1108, (_e1108 < _e829));
let _e1115 = global_2.member[bitcast<u32>(select(0i, _e1110, (_e1110 > 0i)))];
let _e1122 = ((_e1104 >> bitcast<u32>((_e1097 & 31u))) | ((_e1115 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1097) & 31u))));
let _e1123 = local_4.member[2u];
let _e1124 = (_e1090 + _e1123);
let _e1126 = (_e1124 >> bitcast<u32>(1i));
let _e1129 = bitcast<u32>(((_e1124 & 1i) * 16i));
let _e1131 = select(_e829, _e1126, (_e1126 < _e829));
let _e1136 = global_2.member[bitcast<u32>(select(0i, _e1131, (_e1131 > 0i)))];
let _e1140 = (_e1126 + 1i);
let _e1142 = select(_e829, _e1140, (_e1140 < _e829));
let _e1147 = global_2.member[bitcast<u32>(select(0i, _e1142, (_e1142 > 0i)))];
let _e1154 = ((_e1136 >> bitcast<u32>((_e1129 & 31u))) | ((_e1147 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1129) & 31u))));
let _e1155 = local_4.member_1[0u];
let _e1161 = f32(bitcast<i32>(((_e1122 >> bitcast<u32>((_e1155 & 31u))) & 65535u)));
let _e1162 = local_4.member_1[1u];
let _e1168 = f32(bitcast<i32>(((_e1122 >> bitcast<u32>((_e1162 & 31u))) & 65535u)));
let _e1169 = local_4.member_1[4u];
let _e1175 = f32(bitcast<i32>(((_e1154 >> bitcast<u32>((_e1169 & 31u))) & 65535u)));
let _e1176 = local_4.member_1[5u];
let _e1183 = local_5[0u];
let _e1186 = (_e1161 + ((_e1168 - _e1161) * _e1183));
let _e1187 = local_5[0u];
let _e1190 = (_e1168 + ((_e1175 - _e1168) * _e1187));
let _e1191 = local_5[0u];
let _e1194 = (_e1175 + ((f32(bitcast<i32>(((_e1154 >> bitcast<u32>((_e1176 & 31u))) & 65535u))) - _e1175) * _e1191));
let _e1195 = (_e855 + _e850);
let _e1196 = local_4.member[0u];
let _e1197 = (_e1195 + _e1196);
let _e1199 = (_e1197 >> bitcast<u32>(1i));
let _e1202 = bitcast<u32>(((_e1197 & 1i) * 16i));
let _e1204 = select(_e829, _e1199, (_e1199 < _e829));
let _e1209 = global_2.member[bitcast<u32>(select(0i, _e1204, (_e1204 > 0i)))];
let _e1213 = (_e1199 + 1i);
let _e1215 = select(_e829, _e1213, (_e1213 < _e829));
let _e1220 = global_2.member[bitcast<u32>(select(0i, _e1215, (_e1215 > 0i)))];
let _e1227 = ((_e1209 >> bitcast<u32>((_e1202 & 31u))) | ((_e1220 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1202) & 31u))));
let _e1228 = local_4.member[2u];
let _e1229 = (_e1195 + _e1228);
let _e1231 = (_e1229 >> bitcast<u32>(1i));
let _e1234 = bitcast<u32>(((_e1229 & 1i) * 16i));
let _e1236 = select(_e829, _e1231, (_e1231 < _e829));
let _e1241 = global_2.member[bitcast<u32>(select(0i, _e1236, (_e1236 > 0i)))];
let _e1245 = (_e1231 + 1i);
let _e1247 = select(_e829, _e1245, (_e1245 < _e829));
let _e1252 = global_2.member[bitcast<u32>(select(0i, _e1247, (_e1247 > 0i)))];
let _e1259 = ((_e1241 >> bitcast<u32>((_e1234 & 31u))) | ((_e1252 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1234) & 31u))));
let _e1260 = local_4.member_1[0u];
let _e1266 = f32(bitcast<i32>(((_e1227 >> bitcast<u32>((_e1260 & 31u))) & 65535u)));
let _e1267 = local_4.member_1[1u];
let _e1273 = f32(bitcast<i32>(((_e1227 >> bitcast<u32>((_e1267 & 31u))) & 65535u)));
let _e1274 = local_4.member_1[4u];
let _e1280 = f32(bitcast<i32>(((_e1259 >> bitcast<u32>((_e1274 & 31u))) & 65535u)));
let _e1281 = local_4.member_1[5u];
let _e1288 = local_5[0u];
let _e1292 = local_5[0u];
let _e1295 = (_e1273 + ((_e1280 - _e1273) * _e1292));
let _e1296 = local_5[0u];
let _e1303 = local_4.member[1u];
let _e1304 = ((_e853 + _e842) + _e1303);
let _e1306 = (_e1304 >> bitcast<u32>(1i));
let _e1309 = bitcast<u32>(((_e1304 & 1i) * 16i));
let _e1311 = select(_e829, _e1306, (_e1306 < _e829));
let _e1316 = global_2.member[bitcast<u32>(select(0i, _e1311, (_e1311 > 0i)))];
let _e1320 = (_e1306 + 1i);
let _e1322 = select(_e829, _e1320, (_e1320 < _e829));
let _e1327 = global_2.member[bitcast<u32>(select(0i, _e1322, (_e1322 > 0i)))];
let _e1334 = ((_e1316 >> bitcast<u32>((_e1309 & 31u))) | ((_e1327 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1309) & 31u))));
let _e1337 = local_4.member_1[2u];
let _e1343 = f32(bitcast<i32>(((_e1334 >> bitcast<u32>((_e1337 & 31u))) & 65535u)));
let _e1346 = local_4.member_1[3u];
let _e1353 = local_5[0u];
let _e1356 = (_e1343 + ((f32(bitcast<i32>(((_e1334 >> bitcast<u32>((_e1346 & 31u))) & 65535u))) - _e1343) * _e1353));
let _e1358 = local_4.member[1u];
let _e1359 = ((_e853 + _e852) + _e1358);
let _e1361 = (_e1359 >> bitcast<u32>(1i));
let _e1364 = bitcast<u32>(((_e1359 & 1i) * 16i));
let _e1366 = select(_e829, _e1361, (_e1361 < _e829));
let _e1371 = global_2.member[bitcast<u32>(select(0i, _e1366, (_e1366 > 0i)))];
let _e1375 = (_e1361 + 1i);
let _e1377 = select(_e829, _e1375, (_e1375 < _e829));
let _e1382 = global_2.member[bitcast<u32>(select(0i, _e1377, (_e1377 > 0i)))];
let _e1389 = ((_e1371 >> bitcast<u32>((_e1364 & 31u))) | ((_e1382 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1364) & 31u))));
let _e1390 = local_4.member_1[2u];
let _e1396 = f32(bitcast<i32>(((_e1389 >> bitcast<u32>((_e1390 & 31u))) & 65535u)));
let _e1397 = local_4.member_1[3u];
let _e1404 = local_5[0u];
let _e1409 = local_4.member[1u];
let _e1410 = ((_e855 + _e842) + _e1409);
let _e1412 = (_e1410 >> bitcast<u32>(1i));
let _e1415 = bitcast<u32>(((_e1410 & 1i) * 16i));
let _e1417 = select(_e829, _e1412, (_e1412 < _e829));
let _e1422 = global_2.member[bitcast<u32>(select(0i, _e1417, (_e1417 > 0i)))];
let _e1426 = (_e1412 + 1i);
let _e1428 = select(_e829, _e1426, (_e1426 < _e829));
let _e1433 = global_2.member[bitcast<u32>(select(0i, _e1428, (_e1428 > 0i)))];
let _e1440 = ((_e1422 >> bitcast<u32>((_e1415 & 31u))) | ((_e1433 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1415) & 31u))));
let _e1441 = local_4.member_1[2u];
let _e1447 = f32(bitcast<i32>(((_e1440 >> bitcast<u32>((_e1441 & 31u))) & 65535u)));
let _e1448 = local_4.member_1[3u];
let _e1455 = local_5[0u];
let _e1458 = (_e1447 + ((f32(bitcast<i32>(((_e1440 >> bitcast<u32>((_e1448 & 31u))) & 65535u))) - _e1447) * _e1455));
let _e1460 = local_4.member[1u];
let _e1461 = ((_e855 + _e852) + _e1460);
let _e1463 = (_e1461 >> bitcast<u32>(1i));
let _e1466 = bitcast<u32>(((_e1461 & 1i) * 16i));
let _e1468 = select(_e829, _e1463, (_e1463 < _e829));
let _e1473 = global_2.member[bitcast<u32>(select(0i, _e1468, (_e1468 > 0i)))];
let _e1477 = (_e1463 + 1i);
let _e1479 = select(_e829, _e1477, (_e1477 < _e829));
let _e1484 = global_2.member[bitcast<u32>(select(0i, _e1479, (_e1479 > 0i)))];
let _e1491 = ((_e1473 >> bitcast<u32>((_e1466 & 31u))) | ((_e1484 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1466) & 31u))));
let _e1492 = local_4.member_1[2u];
let _e1498 = f32(bitcast<i32>(((_e1491 >> bitcast<u32>((_e1492 & 31u))) & 65535u)));
let _e1499 = local_4.member_1[3u];
let _e1506 = local_5[0u];
let _e1511 = local_4.member[1u];
let _e1512 = ((_e844 + _e848) + _e1511);
let _e1514 = (_e1512 >> bitcast<u32>(1i));
let _e1517 = bitcast<u32>(((_e1512 & 1i) * 16i));
let _e1519 = select(_e829, _e1514, (_e1514 < _e829));
let _e1524 = global_2.member[bitcast<u32>(select(0i, _e1519, (_e1519 > 0i)))];
let _e1528 = (_e1514 + 1i);
let _e1530 = select(_e829, _e1528, (_e1528 < _e829));
let _e1535 = global_2.member[bitcast<u32>(select(0i, _e1530, (_e1530 > 0i)))];
let _e1542 = ((_e1524 >> bitcast<u32>((_e1517 & 31u))) | ((_e1535 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1517) & 31u))));
let _e1543 = local_4.member_1[2u];
let _e1549 = f32(bitcast<i32>(((_e1542 >> bitcast<u32>((_e1543 & 31u))) & 65535u)));
let _e1550 = local_4.member_1[3u];
let _e1557 = local_5[0u];
let _e1560 = (_e1549 + ((f32(bitcast<i32>(((_e1542 >> bitcast<u32>((_e1550 & 31u))) & 65535u))) - _e1549) * _e1557));
let _e1562 = local_4.member[1u];
let _e1563 = ((_e857 + _e848) + _e1562);
let _e1565 = (_e1563 >> bitcast<u32>(1i));
let _e1568 = bitcast<u32>(((_e1563 & 1i) * 16i));
let _e1570 = select(_e829, _e1565, (_e1565 < _e829));
let _e1575 = global_2.member[bitcast<u32>(select(0i, _e1570, (_e1570 > 0i)))];
let _e1579 = (_e1565 + 1i);
let _e1581 = select(_e829, _e1579, (_e1579 < _e829));
let _e1586 = global_2.member[bitcast<u32>(select(0i, _e1581, (_e1581 > 0i)))];
let _e1593 = ((_e1575 >> bitcast<u32>((_e1568 & 31u))) | ((_e1586 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1568) & 31u))));
let _e1594 = local_4.member_1[2u];
let _e1600 = f32(bitcast<i32>(((_e1593 >> bitcast<u32>((_e1594 & 31u))) & 65535u)));
let _e1601 = local_4.member_1[3u];
let _e1608 = local_5[0u];
let _e1611 = (_e1600 + ((f32(bitcast<i32>(((_e1593 >> bitcast<u32>((_e1601 & 31u))) & 65535u))) - _e1600) * _e1608));
let _e1613 = local_4.member[1u];
let _e1614 = ((_e844 + _e850) + _e1613);
let _e1616 = (_e1614 >> bitcast<u32>(1i));
let _e1619 = bitcast<u32>(((_e1614 & 1i) * 16i));
let _e1621 = select(_e829, _e1616, (_e1616 < _e829));
let _e1626 = global_2.member[bitcast<u32>(select(0i, _e1621, (_e1621 > 0i)))];
let _e1630 = (_e1616 + 1i);
let _e1632 = select(_e829, _e1630, (_e1630 < _e829));
let _e1637 = global_2.member[bitcast<u32>(select(0i, _e1632, (_e1632 > 0i)))];
let _e1644 = ((_e1626 >> bitcast<u32>((_e1619 & 31u))) | ((_e1637 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1619) & 31u))));
let _e1645 = local_4.member_1[2u];
let _e1651 = f32(bitcast<i32>(((_e1644 >> bitcast<u32>((_e1645 & 31u))) & 65535u)));
let _e1652 = local_4.member_1[3u];
let _e1659 = local_5[0u];
let _e1664 = local_4.member[1u];
let _e1665 = ((_e857 + _e850) + _e1664);
let _e1667 = (_e1665 >> bitcast<u32>(1i));
let _e1670 = bitcast<u32>(((_e1665 & 1i) * 16i));
let _e1672 = select(_e829, _e1667, (_e1667 < _e829));
let _e1677 = global_2.member[bitcast<u32>(select(0i, _e1672, (_e1672 > 0i)))];
let _e1681 = (_e1667 + 1i);
let _e1683 = select(_e829, _e1681, (_e1681 < _e829));
let _e1688 = global_2.member[bitcast<u32>(select(0i, _e1683, (_e1683 > 0i)))];
let _e1695 = ((_e1677 >> bitcast<u32>((_e1670 & 31u))) | ((_e1688 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1670) & 31u))));
let _e1696 = local_4.member_1[2u];
let _e1702 = f32(bitcast<i32>(((_e1695 >> bitcast<u32>((_e1696 & 31u))) & 65535u)));
let _e1703 = local_4.member_1[3u];
let _e1710 = local_5[0u];
let _e1715 = local_5[1u];
let _e1718 = (_e980 + ((_e1085 - _e980) * _e1715));
let _e1719 = local_5[1u];
let _e1722 = (_e1190 + ((_e1295 - _e1190) * _e1719));
let _e1723 = local_5[1u];
let _e1726 = (_e976 + (((_e1056 + ((_e1063 - _e1056) * _e1078)) - _e976) * _e1723));
let _e1727 = local_5[1u];
let _e1732 = local_5[2u];
let _e1736 = local_5[1u];
let _e1739 = (_e984 + (((_e1070 + ((f32(bitcast<i32>(((_e1049 >> bitcast<u32>((_e1071 & 31u))) & 65535u))) - _e1070) * _e1086)) - _e984) * _e1736));
let _e1740 = local_5[1u];
let _e1744 = local_5[2u];
let _e1748 = local_5[1u];
let _e1751 = (_e1356 + ((_e980 - _e1356) * _e1748));
let _e1752 = local_5[1u];
let _e1756 = local_5[2u];
let _e1760 = local_5[1u];
let _e1763 = (_e1085 + (((_e1396 + ((f32(bitcast<i32>(((_e1389 >> bitcast<u32>((_e1397 & 31u))) & 65535u))) - _e1396) * _e1404)) - _e1085) * _e1760));
let _e1764 = local_5[1u];
let _e1768 = local_5[2u];
let _e1772 = local_5[1u];
let _e1775 = (_e1560 + (((_e1651 + ((f32(bitcast<i32>(((_e1644 >> bitcast<u32>((_e1652 & 31u))) & 65535u))) - _e1651) * _e1659)) - _e1560) * _e1772));
let _e1776 = local_5[2u];
let _e1780 = local_5[1u];
let _e1784 = local_5[2u];
let _e1788 = local_5[2u];
let _e1795 = global_1.member.member_6.member_5;
let _e1800 = global_1.member.member_6.member_6;
let _e1801 = (((_e1718 + ((_e1722 - _e1718) * _e1788)) * _e1795) + _e1800);
let _e1803 = select(0f, _e1801, (_e1801 > 0f));
let _e1805 = select(1f, _e1803, (_e1803 < 1f));
let _e1807 = (((_e1726 + (((_e1186 + (((_e1266 + ((_e1273 - _e1266) * _e1288)) - _e1186) * _e1727)) - _e1726) * _e1732)) * _e1795) + _e1800);
let _e1809 = select(0f, _e1807, (_e1807 > 0f));
let _e1811 = select(1f, _e1809, (_e1809 < 1f));
let _e1813 = (((_e1739 + (((_e1194 + (((_e1280 + ((f32(bitcast<i32>(((_e1259 >> bitcast<u32>((_e1281 & 31u))) & 65535u))) - _e1280) * _e1296)) - _e1194) * _e1740)) - _e1739) * _e1744)) * _e1795) + _e1800);
let _e1815 = select(0f, _e1813, (_e1813 > 0f));
let _e1817 = select(1f, _e1815, (_e1815 < 1f));
let _e1819 = (((_e1751 + (((_e1458 + ((_e1190 - _e1458) * _e1752)) - _e1751) * _e1756)) * _e1795) + _e1800);
let _e1821 = select(0f, _e1819, (_e1819 > 0f));
let _e1823 = select(1f, _e1821, (_e1821 < 1f));
let _e1825 = (((_e1763 + (((_e1295 + (((_e1498 + ((f32(bitcast<i32>(((_e1491 >> bitcast<u32>((_e1499 & 31u))) & 65535u))) - _e1498) * _e1506)) - _e1295) * _e1764)) - _e1763) * _e1768)) * _e1795) + _e1800);
let _e1827 = select(0f, _e1825, (_e1825 > 0f));
let _e1829 = select(1f, _e1827, (_e1827 < 1f));
let _e1831 = (((_e1775 + ((_e1718 - _e1775) * _e1776)) * _e1795) + _e1800);
let _e1833 = select(0f, _e1831, (_e1831 > 0f));
let _e1835 = select(1f, _e1833, (_e1833 < 1f));
let _e1837 = (((_e1722 + (((_e1611 + (((_e1702 + ((f32(bitcast<i32>(((_e1695 >> bitcast<u32>((_e1703 & 31u))) & 65535u))) - _e1702) * _e1710)) - _e1611) * _e1780)) - _e1722) * _e1784)) * _e1795) + _e1800);
let _e1839 = select(0f, _e1837, (_e1837 > 0f));
let _e1841 = select(1f, _e1839, (_e1839 < 1f));
let _e1842 = (_e1805 * 1024f);
let _e1843 = (1024f - 1f);
let _e1845 = select(0f, _e1842, (_e1842 > 0f));
let _e1847 = select(_e1843, _e1845, (_e1845 < _e1843));
let _e1854 = select(0i, select(select(i32(_e1847), i32(-2147483648), (_e1847 < -2147483600f)), 2147483647i, (_e1847 > 2147483500f)), (_e1847 == _e1847));
let _e1858 = (_e1854 - select(0i, 1i, (_e1847 < f32(_e1854))));
let _e1859 = (262147i + _e1858);
let _e1861 = (bitcast<i32>(_e93) - 1i);
let _e1863 = select(_e1861, _e1859, (_e1859 < _e1861));
let _e1869 = global_4.member[bitcast<u32>(select(0i, _e1863, (_e1863 > 0i)))];
let _e1879 = select(_e1861, 262146i, (262146i < _e1861));
let _e1885 = global_4.member[bitcast<u32>(select(0i, _e1879, (_e1879 > 0i)))];
let _e1886 = bitcast<f32>(_e1885);
let _e1887 = (f32((bitcast<i32>((_e1869 & 4095u)) - 2048i)) * _e1886);
let _e1889 = select(_e1861, 262144i, (262144i < _e1861));
let _e1895 = global_4.member[bitcast<u32>(select(0i, _e1889, (_e1889 > 0i)))];
let _e1896 = bitcast<f32>(_e1895);
let _e1898 = select(_e1861, 262145i, (262145i < _e1861));
let _e1904 = global_4.member[bitcast<u32>(select(0i, _e1898, (_e1898 > 0i)))];
let _e1905 = bitcast<f32>(_e1904);
let _e1911 = ((_e1896 + (f32(bitcast<i32>((_e1869 >> bitcast<u32>(12u)))) * _e1905)) + (_e1887 * (_e1842 - f32(_e1858))));
let _e1912 = (_e1887 * 1024f);
if _e716 {
let _e1919 = ((0.5f * (_e1817 - _e1811)) * _e1912);
let _e1920 = ((0.5f * (_e1829 - _e1823)) * _e1912);
let _e1921 = ((0.5f * (_e1841 - _e1835)) * _e1912);
phi_3503_ = type_29(_e1911, vec3<f32>(_e1919, _e1920, _e1921), vec3<f32>((_e1919 * _e1911), (_e1920 * _e1911), (_e1921 * _e1911)));
} else {
let _e1928 = (_e1811 * 1024f);
let _e1930 = select(0f, _e1928, (_e1928 > 0f));
let _e1932 = select(_e1843, _e1930, (_e1930 < _e1843));
let _e1939 = select(0i, select(select(i32(_e1932), i32(-2147483648), (_e1932 < -2147483600f)), 2147483647i, (_e1932 > 2147483500f)), (_e1932 == _e1932));
let _e1943 = (_e1939 - select(0i, 1i, (_e1932 < f32(_e1939))));
let _e1944 = (262147i + _e1943);
let _e1946 = select(_e1861, _e1944, (_e1944 < _e1861));
let _e1952 = global_4.member[bitcast<u32>(select(0i, _e1946, (_e1946 > 0i)))];
let _e1967 = ((_e1896 + (f32(bitcast<i32>((_e1952 >> bitcast<u32>(12u)))) * _e1905)) + ((f32((bitcast<i32>((_e1952 & 4095u)) - 2048i)) * _e1886) * (_e1928 - f32(_e1943))));
let _e1968 = (_e1817 * 1024f);
let _e1970 = select(0f, _e1968, (_e1968 > 0f));
let _e1972 = select(_e1843, _e1970, (_e1970 < _e1843));
let _e1979 = select(0i, select(select(i32(_e1972), i32(-2147483648), (_e1972 < -2147483600f)), 2147483647i, (_e1972 > 2147483500f)), (_e1972 == _e1972));
let _e1983 = (_e1979 - select(0i, 1i, (_e1972 < f32(_e1979))));
let _e1984 = (262147i + _e1983);
let _e1986 = select(_e1861, _e1984, (_e1984 < _e1861));
let _e1992 = global_4.member[bitcast<u32>(select(0i, _e1986, (_e1986 > 0i)))];
let _e2007 = ((_e1896 + (f32(bitcast<i32>((_e1992 >> bitcast<u32>(12u)))) * _e1905)) + ((f32((bitcast<i32>((_e1992 & 4095u)) - 2048i)) * _e1886) * (_e1968 - f32(_e1983))));
let _e2008 = (_e1823 * 1024f);
let _e2010 = select(0f, _e2008, (_e2008 > 0f));
let _e2012 = select(_e1843, _e2010, (_e2010 < _e1843));
let _e2019 = select(0i, select(select(i32(_e2012), i32(-2147483648), (_e2012 < -2147483600f)), 2147483647i, (_e2012 > 2147483500f)), (_e2012 == _e2012));
let _e2023 = (_e2019 - select(0i, 1i, (_e2012 < f32(_e2019))));
let _e2024 = (262147i + _e2023);
let _e2026 = select(_e1861, _e2024, (_e2024 < _e1861));
let _e2032 = global_4.member[bitcast<u32>(select(0i, _e2026, (_e2026 > 0i)))];
let _e2047 = ((_e1896 + (f32(bitcast<i32>((_e2032 >> bitcast<u32>(12u)))) * _e1905)) + ((f32((bitcast<i32>((_e2032 & 4095u)) - 2048i)) * _e1886) * (_e2008 - f32(_e2023))));
let _e2048 = (_e1829 * 1024f);
let _e2050 = select(0f, _e2048, (_e2048 > 0f));
let _e2052 = select(_e1843, _e2050, (_e2050 < _e1843));
let _e2059 = select(0i, select(select(i32(_e2052), i32(-2147483648), (_e2052 < -2147483600f)), 2147483647i, (_e2052 > 2147483500f)), (_e2052 == _e2052));
let _e2063 = (_e2059 - select(0i, 1i, (_e2052 < f32(_e2059))));
let _e2064 = (262147i + _e2063);
let _e2066 = select(_e1861, _e2064, (_e2064 < _e1861));
let _e2072 = global_4.member[bitcast<u32>(select(0i, _e2066, (_e2066 > 0i)))];
let _e2087 = ((_e1896 + (f32(bitcast<i32>((_e2072 >> bitcast<u32>(12u)))) * _e1905)) + ((f32((bitcast<i32>((_e2072 & 4095u)) - 2048i)) * _e1886) * (_e2048 - f32(_e2063))));
let _e2088 = (_e1835 * 1024f);
let _e2090 = select(0f, _e2088, (_e2088 > 0f));
let _e2092 = select(_e1843, _e2090, (_e2090 < _e1843));
let _e2099 = select(0i, select(select(i32(_e2092), i32(-2147483648), (_e2092 < -2147483600f)), 2147483647i, (_e2092 > 2147483500f)), (_e2092 == _e2092));
let _e2103 = (_e2099 - select(0i, 1i, (_e2092 < f32(_e2099))));
let _e2104 = (262147i + _e2103);
let _e2106 = select(_e1861, _e2104, (_e2104 < _e1861));
let _e2112 = global_4.member[bitcast<u32>(select(0i, _e2106, (_e2106 > 0i)))];
let _e2127 = ((_e1896 + (f32(bitcast<i32>((_e2112 >> bitcast<u32>(12u)))) * _e1905)) + ((f32((bitcast<i32>((_e2112 & 4095u)) - 2048i)) * _e1886) * (_e2088 - f32(_e2103))));
let _e2128 = (_e1841 * 1024f);
let _e2130 = select(0f, _e2128, (_e2128 > 0f));
let _e2132 = select(_e1843, _e2130, (_e2130 < _e1843));
let _e2139 = select(0i, select(select(i32(_e2132), i32(-2147483648), (_e2132 < -2147483600f)), 2147483647i, (_e2132 > 2147483500f)), (_e2132 == _e2132));
let _e2143 = (_e2139 - select(0i, 1i, (_e2132 < f32(_e2139))));
let _e2144 = (262147i + _e2143);
let _e2146 = select(_e1861, _e2144, (_e2144 < _e1861));
let _e2152 = global_4.member[bitcast<u32>(select(0i, _e2146, (_e2146 > 0i)))];
let _e2167 = ((_e1896 + (f32(bitcast<i32>((_e2152 >> bitcast<u32>(12u)))) * _e1905)) + ((f32((bitcast<i32>((_e2152 & 4095u)) - 2048i)) * _e1886) * (_e2128 - f32(_e2143))));
let _e2168 = (_e2007 - _e1967);
let _e2170 = (_e2087 - _e2047);
let _e2172 = (_e2167 - _e2127);
phi_3503_ = type_29(_e1911, vec3<f32>((0.5f * _e2168), (0.5f * _e2170), (0.5f * _e2172)), vec3<f32>((0.25f * (_e2168 * (_e2007 + _e1967))), (0.25f * (_e2170 * (_e2087 + _e2047))), (0.25f * (_e2172 * (_e2167 + _e2127)))));
}
let _e2187 = phi_3503_;
let _e2202 = select(0f, 1f, ((((((_e702 >= -0.5f) && (_e702 <= _e725)) && (_e708 >= -0.5f)) && (_e708 <= _e735)) && (_e714 >= -0.5f)) && (_e714 <= _e745)));
let _e2204 = (0.5f * (_e1817 - _e1811));
let _e2206 = (0.5f * (_e1829 - _e1823));
let _e2208 = (0.5f * (_e1841 - _e1835));
let _e2214 = global_1.member.member_6.member.member.member;
let _e2220 = global_1.member.member_6.member.member.member_1;
let _e2226 = global_1.member.member_6.member.member.member_2;
let _e2232 = global_1.member.member_6.member_1.member.member;
let _e2238 = global_1.member.member_6.member_1.member.member_1;
let _e2244 = global_1.member.member_6.member_1.member.member_2;
let _e2250 = global_1.member.member_6.member_2.member.member;
let _e2256 = global_1.member.member_6.member_2.member.member_1;
let _e2262 = global_1.member.member_6.member_2.member.member_2;
phi_4204_ = type_30(_e1805, vec3<f32>(((((_e2214 * _e2204) + (_e2232 * _e2206)) + (_e2250 * _e2208)) * _e2202), ((((_e2220 * _e2204) + (_e2238 * _e2206)) + (_e2256 * _e2208)) * _e2202), ((((_e2226 * _e2204) + (_e2244 * _e2206)) + (_e2262 * _e2208)) * _e2202)), _e2187.member, vec3<f32>(((((_e2214 * _e2187.member_2.x) + (_e2232 * _e2187.member_2.y)) + (_e2250 * _e2187.member_2.z)) * _e2202), ((((_e2220 * _e2187.member_2.x) + (_e2238 * _e2187.member_2.y)) + (_e2256 * _e2187.member_2.z)) * _e2202), ((((_e2226 * _e2187.member_2.x) + (_e2244 * _e2187.member_2.y)) + (_e2262 * _e2187.member_2.z)) * _e2202)), vec3<f32>(((((_e2214 * _e2187.member_1.x) + (_e2232 * _e2187.member_1.y)) + (_e2250 * _e2187.member_1.z)) * _e2202), ((((_e2220 * _e2187.member_1.x) + (_e2238 * _e2187.member_1.y)) + (_e2256 * _e2187.member_1.z)) * _e2202), ((((_e2226 * _e2187.member_1.x) + (_e2244 * _e2187.member_1.y)) + (_e2262 * _e2187.member_1.z)) * _e2202)));
} else {
let _e2331 = global_1.member.member_6.member_3.member;
let _e2332 = (_e2331 - 0.5f);
let _e2334 = select(-0.5f, _e702, (_e702 > -0.5f));
let _e2336 = select(_e2332, _e2334, (_e2334 < _e2332));
let _e2341 = global_1.member.member_6.member_3.member_1;
let _e2342 = (_e2341 - 0.5f);
let _e2344 = select(-0.5f, _e708, (_e708 > -0.5f));
let _e2346 = select(_e2342, _e2344, (_e2344 < _e2342));
let _e2351 = global_1.member.member_6.member_3.member_2;
let _e2352 = (_e2351 - 0.5f);
let _e2354 = select(-0.5f, _e714, (_e714 > -0.5f));
let _e2356 = select(_e2352, _e2354, (_e2354 < _e2352));
let _e2358 = select(-1f, _e2336, (_e2336 > -1f));
let _e2360 = select(_e2331, _e2358, (_e2358 < _e2331));
let _e2367 = select(0i, select(select(i32(_e2360), i32(-2147483648), (_e2360 < -2147483600f)), 2147483647i, (_e2360 > 2147483500f)), (_e2360 == _e2360));
let _e2371 = (_e2367 - select(0i, 1i, (_e2360 < f32(_e2367))));
let _e2373 = select(-1f, _e2346, (_e2346 > -1f));
let _e2375 = select(_e2341, _e2373, (_e2373 < _e2341));
let _e2382 = select(0i, select(select(i32(_e2375), i32(-2147483648), (_e2375 < -2147483600f)), 2147483647i, (_e2375 > 2147483500f)), (_e2375 == _e2375));
let _e2386 = (_e2382 - select(0i, 1i, (_e2375 < f32(_e2382))));
let _e2388 = select(-1f, _e2356, (_e2356 > -1f));
let _e2390 = select(_e2351, _e2388, (_e2388 < _e2351));
let _e2397 = select(0i, select(select(i32(_e2390), i32(-2147483648), (_e2390 < -2147483600f)), 2147483647i, (_e2390 > 2147483500f)), (_e2390 == _e2390));
let _e2401 = (_e2397 - select(0i, 1i, (_e2390 < f32(_e2397))));
let _e2405 = global_1.member.member_6.member_7;
let _e2409 = global_1.member.member_6.member_8;
let _e2410 = (_e2371 + 1i);
let _e2411 = (_e2386 + 1i);
let _e2412 = (_e2401 + 1i);
let _e2417 = global_1.member.member_6.member_11.member;
let _e2423 = global_1.member.member_6.member_11.member_1;
let _e2434 = ((_e2410 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2417) * ((_e2411 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2423) * (_e2412 >> bitcast<u32>(4i))))));
let _e2436 = (bitcast<i32>(_e89) - 1i);
let _e2438 = select(_e2436, _e2434, (_e2434 < _e2436));
let _e2444 = global_2.member[bitcast<u32>(select(0i, _e2438, (_e2438 > 0i)))];
let _e2446 = (_e2410 & 15i);
let _e2449 = ((_e2411 & 15i) * _e2405);
let _e2451 = (bitcast<i32>(_e2444) + ((_e2412 & 15i) * _e2409));
let _e2455 = (_e2449 + _e2405);
let _e2457 = (_e2449 + (2i * _e2405));
let _e2458 = (_e2451 + _e2409);
let _e2460 = (_e2451 + (2i * _e2409));
local_2 = type_28(array<i32, 4>(_e2446, (_e2446 + 1i), (_e2446 + 2i), (_e2446 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e2336 - f32(_e2371)), (_e2346 - f32(_e2386)), (_e2356 - f32(_e2401)));
let _e2474 = local_2.member[1u];
let _e2475 = ((_e2458 + _e2455) + _e2474);
let _e2477 = (_e2475 >> bitcast<u32>(1i));
let _e2480 = bitcast<u32>(((_e2475 & 1i) * 16i));
let _e2482 = select(_e2436, _e2477, (_e2477 < _e2436));
let _e2487 = global_2.member[bitcast<u32>(select(0i, _e2482, (_e2482 > 0i)))];
let _e2491 = (_e2477 + 1i);
let _e2493 = select(_e2436, _e2491, (_e2491 < _e2436));
let _e2498 = global_2.member[bitcast<u32>(select(0i, _e2493, (_e2493 > 0i)))];
let _e2505 = ((_e2487 >> bitcast<u32>((_e2480 & 31u))) | ((_e2498 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2480) & 31u))));
let _e2508 = local_2.member_1[2u];
let _e2514 = f32(bitcast<i32>(((_e2505 >> bitcast<u32>((_e2508 & 31u))) & 65535u)));
let _e2517 = local_2.member_1[3u];
let _e2524 = local_3[0u];
let _e2527 = (_e2514 + ((f32(bitcast<i32>(((_e2505 >> bitcast<u32>((_e2517 & 31u))) & 65535u))) - _e2514) * _e2524));
let _e2529 = local_2.member[1u];
let _e2530 = ((_e2458 + _e2457) + _e2529);
let _e2532 = (_e2530 >> bitcast<u32>(1i));
let _e2535 = bitcast<u32>(((_e2530 & 1i) * 16i));
let _e2537 = select(_e2436, _e2532, (_e2532 < _e2436));
let _e2542 = global_2.member[bitcast<u32>(select(0i, _e2537, (_e2537 > 0i)))];
let _e2546 = (_e2532 + 1i);
let _e2548 = select(_e2436, _e2546, (_e2546 < _e2436));
let _e2553 = global_2.member[bitcast<u32>(select(0i, _e2548, (_e2548 > 0i)))];
let _e2560 = ((_e2542 >> bitcast<u32>((_e2535 & 31u))) | ((_e2553 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2535) & 31u))));
let _e2561 = local_2.member_1[2u];
let _e2567 = f32(bitcast<i32>(((_e2560 >> bitcast<u32>((_e2561 & 31u))) & 65535u)));
let _e2568 = local_2.member_1[3u];
let _e2575 = local_3[0u];
let _e2580 = local_3[1u];
let _e2583 = (_e2527 + (((_e2567 + ((f32(bitcast<i32>(((_e2560 >> bitcast<u32>((_e2568 & 31u))) & 65535u))) - _e2567) * _e2575)) - _e2527) * _e2580));
let _e2585 = local_2.member[1u];
let _e2586 = ((_e2460 + _e2455) + _e2585);
let _e2588 = (_e2586 >> bitcast<u32>(1i));
let _e2591 = bitcast<u32>(((_e2586 & 1i) * 16i));
let _e2593 = select(_e2436, _e2588, (_e2588 < _e2436));
let _e2598 = global_2.member[bitcast<u32>(select(0i, _e2593, (_e2593 > 0i)))];
let _e2602 = (_e2588 + 1i);
let _e2604 = select(_e2436, _e2602, (_e2602 < _e2436));
let _e2609 = global_2.member[bitcast<u32>(select(0i, _e2604, (_e2604 > 0i)))];
let _e2616 = ((_e2598 >> bitcast<u32>((_e2591 & 31u))) | ((_e2609 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2591) & 31u))));
let _e2617 = local_2.member_1[2u];
let _e2623 = f32(bitcast<i32>(((_e2616 >> bitcast<u32>((_e2617 & 31u))) & 65535u)));
let _e2624 = local_2.member_1[3u];
let _e2631 = local_3[0u];
let _e2634 = (_e2623 + ((f32(bitcast<i32>(((_e2616 >> bitcast<u32>((_e2624 & 31u))) & 65535u))) - _e2623) * _e2631));
let _e2636 = local_2.member[1u];
let _e2637 = ((_e2460 + _e2457) + _e2636);
let _e2639 = (_e2637 >> bitcast<u32>(1i));
let _e2642 = bitcast<u32>(((_e2637 & 1i) * 16i));
let _e2644 = select(_e2436, _e2639, (_e2639 < _e2436));
let _e2649 = global_2.member[bitcast<u32>(select(0i, _e2644, (_e2644 > 0i)))];
let _e2653 = (_e2639 + 1i);
let _e2655 = select(_e2436, _e2653, (_e2653 < _e2436));
let _e2660 = global_2.member[bitcast<u32>(select(0i, _e2655, (_e2655 > 0i)))];
let _e2667 = ((_e2649 >> bitcast<u32>((_e2642 & 31u))) | ((_e2660 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2642) & 31u))));
let _e2668 = local_2.member_1[2u];
let _e2674 = f32(bitcast<i32>(((_e2667 >> bitcast<u32>((_e2668 & 31u))) & 65535u)));
let _e2675 = local_2.member_1[3u];
let _e2682 = local_3[0u];
let _e2686 = local_3[1u];
let _e2691 = local_3[2u];
let _e2698 = global_1.member.member_6.member_5;
let _e2703 = global_1.member.member_6.member_6;
let _e2704 = (((_e2583 + (((_e2634 + (((_e2674 + ((f32(bitcast<i32>(((_e2667 >> bitcast<u32>((_e2675 & 31u))) & 65535u))) - _e2674) * _e2682)) - _e2634) * _e2686)) - _e2583) * _e2691)) * _e2698) + _e2703);
let _e2706 = select(0f, _e2704, (_e2704 > 0f));
phi_4204_ = type_30(select(1f, _e2706, (_e2706 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2711 = phi_4204_;
let _e2716 = global_1.member.member_6.member_3.member;
let _e2717 = (_e2716 - 0.5f);
let _e2719 = select(-0.5f, _e666, (_e666 > -0.5f));
let _e2721 = select(_e2717, _e2719, (_e2719 < _e2717));
let _e2726 = global_1.member.member_6.member_3.member_1;
let _e2727 = (_e2726 - 0.5f);
let _e2729 = select(-0.5f, _e681, (_e681 > -0.5f));
let _e2731 = select(_e2727, _e2729, (_e2729 < _e2727));
let _e2736 = global_1.member.member_6.member_3.member_2;
let _e2737 = (_e2736 - 0.5f);
let _e2739 = select(-0.5f, _e696, (_e696 > -0.5f));
let _e2741 = select(_e2737, _e2739, (_e2739 < _e2737));
let _e2743 = select(-1f, _e2721, (_e2721 > -1f));
let _e2745 = select(_e2716, _e2743, (_e2743 < _e2716));
let _e2752 = select(0i, select(select(i32(_e2745), i32(-2147483648), (_e2745 < -2147483600f)), 2147483647i, (_e2745 > 2147483500f)), (_e2745 == _e2745));
let _e2756 = (_e2752 - select(0i, 1i, (_e2745 < f32(_e2752))));
let _e2758 = select(-1f, _e2731, (_e2731 > -1f));
let _e2760 = select(_e2726, _e2758, (_e2758 < _e2726));
let _e2767 = select(0i, select(select(i32(_e2760), i32(-2147483648), (_e2760 < -2147483600f)), 2147483647i, (_e2760 > 2147483500f)), (_e2760 == _e2760));
let _e2771 = (_e2767 - select(0i, 1i, (_e2760 < f32(_e2767))));
let _e2773 = select(-1f, _e2741, (_e2741 > -1f));
let _e2775 = select(_e2736, _e2773, (_e2773 < _e2736));
let _e2782 = select(0i, select(select(i32(_e2775), i32(-2147483648), (_e2775 < -2147483600f)), 2147483647i, (_e2775 > 2147483500f)), (_e2775 == _e2775));
let _e2786 = (_e2782 - select(0i, 1i, (_e2775 < f32(_e2782))));
let _e2790 = global_1.member.member_6.member_7;
let _e2794 = global_1.member.member_6.member_8;
let _e2795 = (_e2756 + 1i);
let _e2796 = (_e2771 + 1i);
let _e2797 = (_e2786 + 1i);
let _e2802 = global_1.member.member_6.member_11.member;
let _e2808 = global_1.member.member_6.member_11.member_1;
let _e2819 = ((_e2795 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2802) * ((_e2796 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2808) * (_e2797 >> bitcast<u32>(4i))))));
let _e2821 = (bitcast<i32>(_e89) - 1i);
let _e2823 = select(_e2821, _e2819, (_e2819 < _e2821));
let _e2829 = global_2.member[bitcast<u32>(select(0i, _e2823, (_e2823 > 0i)))];
let _e2831 = (_e2795 & 15i);
let _e2834 = ((_e2796 & 15i) * _e2790);
let _e2836 = (bitcast<i32>(_e2829) + ((_e2797 & 15i) * _e2794));
let _e2840 = (_e2834 + _e2790);
let _e2842 = (_e2834 + (2i * _e2790));
let _e2843 = (_e2836 + _e2794);
let _e2845 = (_e2836 + (2i * _e2794));
local = type_28(array<i32, 4>(_e2831, (_e2831 + 1i), (_e2831 + 2i), (_e2831 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_1 = vec3<f32>((_e2721 - f32(_e2756)), (_e2731 - f32(_e2771)), (_e2741 - f32(_e2786)));
let _e2859 = local.member[1u];
let _e2860 = ((_e2843 + _e2840) + _e2859);
let _e2862 = (_e2860 >> bitcast<u32>(1i));
let _e2865 = bitcast<u32>(((_e2860 & 1i) * 16i));
let _e2867 = select(_e2821, _e2862, (_e2862 < _e2821));
let _e2872 = global_2.member[bitcast<u32>(select(0i, _e2867, (_e2867 > 0i)))];
let _e2876 = (_e2862 + 1i);
let _e2878 = select(_e2821, _e2876, (_e2876 < _e2821));
let _e2883 = global_2.member[bitcast<u32>(select(0i, _e2878, (_e2878 > 0i)))];
let _e2890 = ((_e2872 >> bitcast<u32>((_e2865 & 31u))) | ((_e2883 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2865) & 31u))));
let _e2893 = local.member_1[2u];
let _e2899 = f32(bitcast<i32>(((_e2890 >> bitcast<u32>((_e2893 & 31u))) & 65535u)));
let _e2902 = local.member_1[3u];
let _e2909 = local_1[0u];
let _e2912 = (_e2899 + ((f32(bitcast<i32>(((_e2890 >> bitcast<u32>((_e2902 & 31u))) & 65535u))) - _e2899) * _e2909));
let _e2914 = local.member[1u];
let _e2915 = ((_e2843 + _e2842) + _e2914);
let _e2917 = (_e2915 >> bitcast<u32>(1i));
let _e2920 = bitcast<u32>(((_e2915 & 1i) * 16i));
let _e2922 = select(_e2821, _e2917, (_e2917 < _e2821));
let _e2927 = global_2.member[bitcast<u32>(select(0i, _e2922, (_e2922 > 0i)))];
let _e2931 = (_e2917 + 1i);
let _e2933 = select(_e2821, _e2931, (_e2931 < _e2821));
let _e2938 = global_2.member[bitcast<u32>(select(0i, _e2933, (_e2933 > 0i)))];
let _e2945 = ((_e2927 >> bitcast<u32>((_e2920 & 31u))) | ((_e2938 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2920) & 31u))));
let _e2946 = local.member_1[2u];
let _e2952 = f32(bitcast<i32>(((_e2945 >> bitcast<u32>((_e2946 & 31u))) & 65535u)));
let _e2953 = local.member_1[3u];
let _e2960 = local_1[0u];
let _e2965 = local_1[1u];
let _e2968 = (_e2912 + (((_e2952 + ((f32(bitcast<i32>(((_e2945 >> bitcast<u32>((_e2953 & 31u))) & 65535u))) - _e2952) * _e2960)) - _e2912) * _e2965));
let _e2970 = local.member[1u];
let _e2971 = ((_e2845 + _e2840) + _e2970);
let _e2973 = (_e2971 >> bitcast<u32>(1i));
let _e2976 = bitcast<u32>(((_e2971 & 1i) * 16i));
let _e2978 = select(_e2821, _e2973, (_e2973 < _e2821));
let _e2983 = global_2.member[bitcast<u32>(select(0i, _e2978, (_e2978 > 0i)))];
let _e2987 = (_e2973 + 1i);
let _e2989 = select(_e2821, _e2987, (_e2987 < _e2821));
let _e2994 = global_2.member[bitcast<u32>(select(0i, _e2989, (_e2989 > 0i)))];
let _e3001 = ((_e2983 >> bitcast<u32>((_e2976 & 31u))) | ((_e2994 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2976) & 31u))));
let _e3002 = local.member_1[2u];
let _e3008 = f32(bitcast<i32>(((_e3001 >> bitcast<u32>((_e3002 & 31u))) & 65535u)));
let _e3009 = local.member_1[3u];
let _e3016 = local_1[0u];
let _e3019 = (_e3008 + ((f32(bitcast<i32>(((_e3001 >> bitcast<u32>((_e3009 & 31u))) & 65535u))) - _e3008) * _e3016));
let _e3021 = local.member[1u];
let _e3022 = ((_e2845 + _e2842) + _e3021);
let _e3024 = (_e3022 >> bitcast<u32>(1i));
let _e3027 = bitcast<u32>(((_e3022 & 1i) * 16i));
let _e3029 = select(_e2821, _e3024, (_e3024 < _e2821));
let _e3034 = global_2.member[bitcast<u32>(select(0i, _e3029, (_e3029 > 0i)))];
let _e3038 = (_e3024 + 1i);
let _e3040 = select(_e2821, _e3038, (_e3038 < _e2821));
let _e3045 = global_2.member[bitcast<u32>(select(0i, _e3040, (_e3040 > 0i)))];
let _e3052 = ((_e3034 >> bitcast<u32>((_e3027 & 31u))) | ((_e3045 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3027) & 31u))));
let _e3053 = local.member_1[2u];
let _e3059 = f32(bitcast<i32>(((_e3052 >> bitcast<u32>((_e3053 & 31u))) & 65535u)));
let _e3060 = local.member_1[3u];
let _e3067 = local_1[0u];
let _e3071 = local_1[1u];
let _e3076 = local_1[2u];
let _e3083 = global_1.member.member_6.member_5;
let _e3088 = global_1.member.member_6.member_6;
let _e3089 = (((_e2968 + (((_e3019 + (((_e3059 + ((f32(bitcast<i32>(((_e3052 >> bitcast<u32>((_e3060 & 31u))) & 65535u))) - _e3059) * _e3067)) - _e3019) * _e3071)) - _e2968) * _e3076)) * _e3083) + _e3088);
let _e3091 = select(0f, _e3089, (_e3089 > 0f));
let _e3093 = select(1f, _e3091, (_e3091 < 1f));
let _e3096 = global_1.member.member_1;
if ((_e3096 & 16u) == 0u) {
phi_5092_ = type_5(1f, 1f, 1f);
} else {
let _e3102 = global_1.member.member_14.member;
let _e3113 = ((((_e3102.member.member * _e623) + (_e3102.member.member_1 * _e636)) + (_e3102.member.member_2 * _e601)) + _e3102.member_1);
let _e3119 = ((((_e3102.member.member * _e646) + (_e3102.member.member_1 * _e651)) + (_e3102.member.member_2 * _e640)) + _e3102.member_1);
let _e3121 = select(_e3119, _e3113, (_e3113 < _e3119));
let _e3123 = select(_e3119, _e3113, (_e3113 > _e3119));
let _e3125 = (_e3123 - _e3121);
let _e3128 = (-(_e3121) / select(1e-30f, _e3125, (_e3125 > 1e-30f)));
let _e3130 = select(0f, _e3128, (_e3128 > 0f));
let _e3136 = select(select(select(1f, _e3130, (_e3130 < 1f)), 1f, (_e3123 <= 0f)), 0f, (_e3121 > 0f));
let _e3141 = global_1.member.member_14.member_1;
let _e3142 = (_e3141 != 0u);
let _e3152 = global_1.member.member_15.member;
let _e3163 = ((((_e3152.member.member * _e623) + (_e3152.member.member_1 * _e636)) + (_e3152.member.member_2 * _e601)) + _e3152.member_1);
let _e3169 = ((((_e3152.member.member * _e646) + (_e3152.member.member_1 * _e651)) + (_e3152.member.member_2 * _e640)) + _e3152.member_1);
let _e3171 = select(_e3169, _e3163, (_e3163 < _e3169));
let _e3173 = select(_e3169, _e3163, (_e3163 > _e3169));
let _e3175 = (_e3173 - _e3171);
let _e3178 = (-(_e3171) / select(1e-30f, _e3175, (_e3175 > 1e-30f)));
let _e3180 = select(0f, _e3178, (_e3178 > 0f));
let _e3186 = select(select(select(1f, _e3180, (_e3180 < 1f)), 1f, (_e3173 <= 0f)), 0f, (_e3171 > 0f));
let _e3191 = global_1.member.member_15.member_1;
let _e3192 = (_e3191 != 0u);
let _e3202 = global_1.member.member_16.member;
let _e3213 = ((((_e3202.member.member * _e623) + (_e3202.member.member_1 * _e636)) + (_e3202.member.member_2 * _e601)) + _e3202.member_1);
let _e3219 = ((((_e3202.member.member * _e646) + (_e3202.member.member_1 * _e651)) + (_e3202.member.member_2 * _e640)) + _e3202.member_1);
let _e3221 = select(_e3219, _e3213, (_e3213 < _e3219));
let _e3223 = select(_e3219, _e3213, (_e3213 > _e3219));
let _e3225 = (_e3223 - _e3221);
let _e3228 = (-(_e3221) / select(1e-30f, _e3225, (_e3225 > 1e-30f)));
let _e3230 = select(0f, _e3228, (_e3228 > 0f));
let _e3236 = select(select(select(1f, _e3230, (_e3230 < 1f)), 1f, (_e3223 <= 0f)), 0f, (_e3221 > 0f));
let _e3241 = global_1.member.member_16.member_1;
let _e3242 = (_e3241 != 0u);
let _e3252 = global_1.member.member_17.member;
let _e3263 = ((((_e3252.member.member * _e623) + (_e3252.member.member_1 * _e636)) + (_e3252.member.member_2 * _e601)) + _e3252.member_1);
let _e3269 = ((((_e3252.member.member * _e646) + (_e3252.member.member_1 * _e651)) + (_e3252.member.member_2 * _e640)) + _e3252.member_1);
let _e3271 = select(_e3269, _e3263, (_e3263 < _e3269));
let _e3273 = select(_e3269, _e3263, (_e3263 > _e3269));
let _e3275 = (_e3273 - _e3271);
let _e3278 = (-(_e3271) / select(1e-30f, _e3275, (_e3275 > 1e-30f)));
let _e3280 = select(0f, _e3278, (_e3278 > 0f));
let _e3286 = select(select(select(1f, _e3280, (_e3280 < 1f)), 1f, (_e3273 <= 0f)), 0f, (_e3271 > 0f));
let _e3291 = global_1.member.member_17.member_1;
let _e3292 = (_e3291 != 0u);
phi_5092_ = type_5(((((1f * _e3136) * _e3186) * _e3236) * _e3286), ((((1f * select(1f, _e3136, _e3142)) * select(1f, _e3186, _e3192)) * select(1f, _e3236, _e3242)) * select(1f, _e3286, _e3292)), ((((1f * select(1f, 0f, (_e3142 && (_e3119 > 0f)))) * select(1f, 0f, (_e3192 && (_e3169 > 0f)))) * select(1f, 0f, (_e3242 && (_e3219 > 0f)))) * select(1f, 0f, (_e3292 && (_e3269 > 0f)))));
}
let _e3301 = phi_5092_;
let _e3302 = (_e702 - _e666);
let _e3306 = (bitcast<f32>((bitcast<u32>(_e3302) & 2147483647u)) < 1e-12f);
let _e3308 = (1f / select(_e3302, 1f, _e3306));
let _e3310 = ((-0.5f - _e666) * _e3308);
let _e3312 = ((_e2717 - _e666) * _e3308);
let _e3318 = select(_e3312, _e3310, (_e3310 < _e3312));
let _e3320 = select(0f, _e3318, (_e3318 > 0f));
let _e3323 = select(select(1f, _e3320, (_e3320 < 1f)), select(2f, 0f, ((_e666 >= -0.5f) && (_e666 <= _e2717))), _e3306);
let _e3325 = select(_e3312, _e3310, (_e3310 > _e3312));
let _e3327 = select(0f, _e3325, (_e3325 > 0f));
let _e3330 = select(select(1f, _e3327, (_e3327 < 1f)), 1f, _e3306);
let _e3331 = (_e708 - _e681);
let _e3335 = (bitcast<f32>((bitcast<u32>(_e3331) & 2147483647u)) < 1e-12f);
let _e3337 = (1f / select(_e3331, 1f, _e3335));
let _e3339 = ((-0.5f - _e681) * _e3337);
let _e3341 = ((_e2727 - _e681) * _e3337);
let _e3347 = select(_e3341, _e3339, (_e3339 < _e3341));
let _e3349 = select(0f, _e3347, (_e3347 > 0f));
let _e3352 = select(select(1f, _e3349, (_e3349 < 1f)), select(2f, 0f, ((_e681 >= -0.5f) && (_e681 <= _e2727))), _e3335);
let _e3354 = select(_e3341, _e3339, (_e3339 > _e3341));
let _e3356 = select(0f, _e3354, (_e3354 > 0f));
let _e3359 = select(select(1f, _e3356, (_e3356 < 1f)), 1f, _e3335);
let _e3360 = (_e714 - _e696);
let _e3364 = (bitcast<f32>((bitcast<u32>(_e3360) & 2147483647u)) < 1e-12f);
let _e3366 = (1f / select(_e3360, 1f, _e3364));
let _e3368 = ((-0.5f - _e696) * _e3366);
let _e3370 = ((_e2737 - _e696) * _e3366);
let _e3376 = select(_e3370, _e3368, (_e3368 < _e3370));
let _e3378 = select(0f, _e3376, (_e3376 > 0f));
let _e3381 = select(select(1f, _e3378, (_e3378 < 1f)), select(2f, 0f, ((_e696 >= -0.5f) && (_e696 <= _e2737))), _e3364);
let _e3383 = select(_e3370, _e3368, (_e3368 > _e3370));
let _e3385 = select(0f, _e3383, (_e3383 > 0f));
let _e3388 = select(select(1f, _e3385, (_e3385 < 1f)), 1f, _e3364);
let _e3390 = select(_e3359, _e3330, (_e3330 < _e3359));
let _e3394 = select(_e3352, _e3323, (_e3323 > _e3352));
let _e3397 = (select(_e3388, _e3390, (_e3390 < _e3388)) - select(_e3381, _e3394, (_e3394 > _e3381)));
let _e3400 = (_e646 - _e623);
let _e3401 = (_e651 - _e636);
let _e3402 = (_e640 - _e601);
let _e3407 = (((_e3400 * _e3400) + (_e3401 * _e3401)) + (_e3402 * _e3402));
let _e3415 = global_1.member.member_5.member_3;
let _e3416 = ((sqrt(select(0f, _e3407, (_e3407 > 0f))) * select(0f, _e3397, (_e3397 > 0f))) * _e3415);
if (_e103.member_2 >= 3u) {
let _e3419 = (_e3093 * 255f);
let _e3420 = (_e2711.member * 255f);
let _e3421 = (255f - 1f);
let _e3423 = select(0f, _e3419, (_e3419 > 0f));
let _e3425 = select(_e3421, _e3423, (_e3423 < _e3421));
let _e3432 = select(0i, select(select(i32(_e3425), i32(-2147483648), (_e3425 < -2147483600f)), 2147483647i, (_e3425 > 2147483500f)), (_e3425 == _e3425));
let _e3436 = (_e3432 - select(0i, 1i, (_e3425 < f32(_e3432))));
let _e3438 = select(0f, _e3420, (_e3420 > 0f));
let _e3440 = select(_e3421, _e3438, (_e3438 < _e3421));
let _e3447 = select(0i, select(select(i32(_e3440), i32(-2147483648), (_e3440 < -2147483600f)), 2147483647i, (_e3440 > 2147483500f)), (_e3440 == _e3440));
let _e3451 = (_e3447 - select(0i, 1i, (_e3440 < f32(_e3447))));
let _e3454 = (((_e3436 * 256i) + _e3451) * 4i);
let _e3458 = (_e3420 - f32(_e3451));
let _e3460 = (bitcast<i32>(_e93) - 1i);
let _e3462 = select(_e3460, _e3454, (_e3454 < _e3460));
let _e3468 = global_4.member[bitcast<u32>(select(0i, _e3462, (_e3462 > 0i)))];
let _e3469 = (_e3454 + 4i);
let _e3471 = select(_e3460, _e3469, (_e3469 < _e3460));
let _e3477 = global_4.member[bitcast<u32>(select(0i, _e3471, (_e3471 > 0i)))];
let _e3478 = (_e3454 + 1024i);
let _e3480 = select(_e3460, _e3478, (_e3478 < _e3460));
let _e3486 = global_4.member[bitcast<u32>(select(0i, _e3480, (_e3480 > 0i)))];
let _e3487 = (_e3454 + 1028i);
let _e3489 = select(_e3460, _e3487, (_e3487 < _e3460));
let _e3495 = global_4.member[bitcast<u32>(select(0i, _e3489, (_e3489 > 0i)))];
let _e3500 = (bitcast<f32>(((_e3468 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3508 = (_e3500 + (((bitcast<f32>(((_e3477 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3500) * _e3458));
let _e3513 = (bitcast<f32>(((_e3486 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3524 = (_e3508 + (((_e3513 + (((bitcast<f32>(((_e3495 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3513) * _e3458)) - _e3508) * (_e3419 - f32(_e3436))));
let _e3528 = -((_e3524 * (_e3416 * _e3301.member)));
let _e3530 = select(-87f, _e3528, (_e3528 > -87f));
let _e3532 = select(88f, _e3530, (_e3530 < 88f));
let _e3534 = ((_e3532 * 1.442695f) + 0.5f);
let _e3536 = select(-127f, _e3534, (_e3534 > -127f));
let _e3538 = select(128f, _e3536, (_e3536 < 128f));
let _e3545 = select(0i, select(select(i32(_e3538), i32(-2147483648), (_e3538 < -2147483600f)), 2147483647i, (_e3538 > 2147483500f)), (_e3538 == _e3538));
let _e3549 = (_e3545 - select(0i, 1i, (_e3538 < f32(_e3545))));
let _e3550 = f32(_e3549);
let _e3554 = ((_e3532 - (_e3550 * 0.6933594f)) - (_e3550 * -2.1219444e-4f));
let _e3574 = ((1f + (_e3554 * (1f + (_e3554 * (0.5f + (_e3554 * (0.16666667f + (_e3554 * (0.041666668f + (_e3554 * (0.008333334f + (_e3554 * (0.001388889f + (_e3554 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3549 + 127i)) << bitcast<u32>(23i))));
let _e3575 = (1f - _e3574);
phi_6202_ = type_31(_e3574, _e3575, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e3575 / select(1e-12f, _e3524, (_e3524 > 1e-12f))))));
} else {
let _e3583 = (_e3093 * 255f);
let _e3584 = (_e2711.member * 255f);
let _e3585 = (255f - 1f);
let _e3587 = select(0f, _e3583, (_e3583 > 0f));
let _e3589 = select(_e3585, _e3587, (_e3587 < _e3585));
let _e3596 = select(0i, select(select(i32(_e3589), i32(-2147483648), (_e3589 < -2147483600f)), 2147483647i, (_e3589 > 2147483500f)), (_e3589 == _e3589));
let _e3600 = (_e3596 - select(0i, 1i, (_e3589 < f32(_e3596))));
let _e3602 = select(0f, _e3584, (_e3584 > 0f));
let _e3604 = select(_e3585, _e3602, (_e3602 < _e3585));
let _e3611 = select(0i, select(select(i32(_e3604), i32(-2147483648), (_e3604 < -2147483600f)), 2147483647i, (_e3604 > 2147483500f)), (_e3604 == _e3604));
let _e3615 = (_e3611 - select(0i, 1i, (_e3604 < f32(_e3611))));
let _e3618 = (((_e3600 * 256i) + _e3615) * 4i);
let _e3620 = (_e3583 - f32(_e3600));
let _e3622 = (_e3584 - f32(_e3615));
let _e3624 = (bitcast<i32>(_e93) - 1i);
let _e3626 = select(_e3624, _e3618, (_e3618 < _e3624));
let _e3632 = global_4.member[bitcast<u32>(select(0i, _e3626, (_e3626 > 0i)))];
let _e3633 = (_e3618 + 4i);
let _e3635 = select(_e3624, _e3633, (_e3633 < _e3624));
let _e3641 = global_4.member[bitcast<u32>(select(0i, _e3635, (_e3635 > 0i)))];
let _e3642 = (_e3618 + 1024i);
let _e3644 = select(_e3624, _e3642, (_e3642 < _e3624));
let _e3650 = global_4.member[bitcast<u32>(select(0i, _e3644, (_e3644 > 0i)))];
let _e3651 = (_e3618 + 1028i);
let _e3653 = select(_e3624, _e3651, (_e3651 < _e3624));
let _e3659 = global_4.member[bitcast<u32>(select(0i, _e3653, (_e3653 > 0i)))];
let _e3664 = (bitcast<f32>(((_e3632 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3672 = (_e3664 + (((bitcast<f32>(((_e3641 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3664) * _e3622));
let _e3677 = (bitcast<f32>(((_e3650 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3688 = (_e3672 + (((_e3677 + (((bitcast<f32>(((_e3659 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3677) * _e3622)) - _e3672) * _e3620));
let _e3701 = (bitcast<f32>((((_e3632 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3709 = (_e3701 + (((bitcast<f32>((((_e3641 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3701) * _e3622));
let _e3714 = (bitcast<f32>((((_e3650 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3726 = (_e3618 + 1i);
let _e3728 = select(_e3624, _e3726, (_e3726 < _e3624));
let _e3734 = global_4.member[bitcast<u32>(select(0i, _e3728, (_e3728 > 0i)))];
let _e3735 = (_e3618 + 5i);
let _e3737 = select(_e3624, _e3735, (_e3735 < _e3624));
let _e3743 = global_4.member[bitcast<u32>(select(0i, _e3737, (_e3737 > 0i)))];
let _e3744 = (_e3618 + 1025i);
let _e3746 = select(_e3624, _e3744, (_e3744 < _e3624));
let _e3752 = global_4.member[bitcast<u32>(select(0i, _e3746, (_e3746 > 0i)))];
let _e3753 = (_e3618 + 1029i);
let _e3755 = select(_e3624, _e3753, (_e3753 < _e3624));
let _e3761 = global_4.member[bitcast<u32>(select(0i, _e3755, (_e3755 > 0i)))];
let _e3766 = (bitcast<f32>(((_e3734 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3774 = (_e3766 + (((bitcast<f32>(((_e3743 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3766) * _e3622));
let _e3779 = (bitcast<f32>(((_e3752 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3803 = (bitcast<f32>((((_e3734 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3811 = (_e3803 + (((bitcast<f32>((((_e3743 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3803) * _e3622));
let _e3816 = (bitcast<f32>((((_e3752 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3831 = (_e3416 * _e3301.member_1);
let _e3833 = -(((_e3709 + (((_e3714 + (((bitcast<f32>((((_e3659 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3714) * _e3622)) - _e3709) * _e3620)) * _e3831));
let _e3835 = select(-87f, _e3833, (_e3833 > -87f));
let _e3837 = select(88f, _e3835, (_e3835 < 88f));
let _e3839 = ((_e3837 * 1.442695f) + 0.5f);
let _e3841 = select(-127f, _e3839, (_e3839 > -127f));
let _e3843 = select(128f, _e3841, (_e3841 < 128f));
let _e3850 = select(0i, select(select(i32(_e3843), i32(-2147483648), (_e3843 < -2147483600f)), 2147483647i, (_e3843 > 2147483500f)), (_e3843 == _e3843));
let _e3854 = (_e3850 - select(0i, 1i, (_e3843 < f32(_e3850))));
let _e3855 = f32(_e3854);
let _e3859 = ((_e3837 - (_e3855 * 0.6933594f)) - (_e3855 * -2.1219444e-4f));
let _e3881 = -(((_e3774 + (((_e3779 + (((bitcast<f32>(((_e3761 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3779) * _e3622)) - _e3774) * _e3620)) * _e3831));
let _e3883 = select(-87f, _e3881, (_e3881 > -87f));
let _e3885 = select(88f, _e3883, (_e3883 < 88f));
let _e3887 = ((_e3885 * 1.442695f) + 0.5f);
let _e3889 = select(-127f, _e3887, (_e3887 > -127f));
let _e3891 = select(128f, _e3889, (_e3889 < 128f));
let _e3898 = select(0i, select(select(i32(_e3891), i32(-2147483648), (_e3891 < -2147483600f)), 2147483647i, (_e3891 > 2147483500f)), (_e3891 == _e3891));
let _e3902 = (_e3898 - select(0i, 1i, (_e3891 < f32(_e3898))));
let _e3903 = f32(_e3902);
let _e3907 = ((_e3885 - (_e3903 * 0.6933594f)) - (_e3903 * -2.1219444e-4f));
let _e3929 = -(((_e3811 + (((_e3816 + (((bitcast<f32>((((_e3761 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3816) * _e3622)) - _e3811) * _e3620)) * _e3831));
let _e3931 = select(-87f, _e3929, (_e3929 > -87f));
let _e3933 = select(88f, _e3931, (_e3931 < 88f));
let _e3935 = ((_e3933 * 1.442695f) + 0.5f);
let _e3937 = select(-127f, _e3935, (_e3935 > -127f));
let _e3939 = select(128f, _e3937, (_e3937 < 128f));
let _e3946 = select(0i, select(select(i32(_e3939), i32(-2147483648), (_e3939 < -2147483600f)), 2147483647i, (_e3939 > 2147483500f)), (_e3939 == _e3939));
let _e3950 = (_e3946 - select(0i, 1i, (_e3939 < f32(_e3946))));
let _e3951 = f32(_e3950);
let _e3955 = ((_e3933 - (_e3951 * 0.6933594f)) - (_e3951 * -2.1219444e-4f));
let _e3978 = -((_e3688 * (_e3416 * _e3301.member)));
let _e3980 = select(-87f, _e3978, (_e3978 > -87f));
let _e3982 = select(88f, _e3980, (_e3980 < 88f));
let _e3984 = ((_e3982 * 1.442695f) + 0.5f);
let _e3986 = select(-127f, _e3984, (_e3984 > -127f));
let _e3988 = select(128f, _e3986, (_e3986 < 128f));
let _e3995 = select(0i, select(select(i32(_e3988), i32(-2147483648), (_e3988 < -2147483600f)), 2147483647i, (_e3988 > 2147483500f)), (_e3988 == _e3988));
let _e3999 = (_e3995 - select(0i, 1i, (_e3988 < f32(_e3995))));
let _e4000 = f32(_e3999);
let _e4004 = ((_e3982 - (_e4000 * 0.6933594f)) - (_e4000 * -2.1219444e-4f));
let _e4024 = ((1f + (_e4004 * (1f + (_e4004 * (0.5f + (_e4004 * (0.16666667f + (_e4004 * (0.041666668f + (_e4004 * (0.008333334f + (_e4004 * (0.001388889f + (_e4004 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3999 + 127i)) << bitcast<u32>(23i))));
let _e4025 = (1f - _e4024);
phi_6202_ = type_31(_e4024, _e4025, vec3<f32>(((1f + (_e3859 * (1f + (_e3859 * (0.5f + (_e3859 * (0.16666667f + (_e3859 * (0.041666668f + (_e3859 * (0.008333334f + (_e3859 * (0.001388889f + (_e3859 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3854 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3907 * (1f + (_e3907 * (0.5f + (_e3907 * (0.16666667f + (_e3907 * (0.041666668f + (_e3907 * (0.008333334f + (_e3907 * (0.001388889f + (_e3907 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3902 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3955 * (1f + (_e3955 * (0.5f + (_e3955 * (0.16666667f + (_e3955 * (0.041666668f + (_e3955 * (0.008333334f + (_e3955 * (0.001388889f + (_e3955 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3950 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e4025 / select(1e-12f, _e3688, (_e3688 > 1e-12f))))));
}
let _e4033 = phi_6202_;
if _e719 {
let _e4037 = global_1.member.member_5.member_2;
let _e4045 = global_1.member.member_5.member_4;
let _e4048 = (_e2711.member_3.x * _e3301.member_2);
let _e4050 = (_e2711.member_3.y * _e3301.member_2);
let _e4052 = (_e2711.member_3.z * _e3301.member_2);
let _e4053 = (0.5f * (_e4037 / select(1e-6f, _e183, (_e183 > 1e-6f))));
let _e4057 = (_e161 + (_e4048 * _e4053));
let _e4058 = (_e172 + (_e4050 * _e4053));
let _e4059 = (_e183 + (_e4052 * _e4053));
let _e4061 = (2f * _e4037);
let _e4063 = ((_e4059 * _e4059) + (_e4061 * _e4052));
let _e4067 = (_e4059 + sqrt(select(0f, _e4063, (_e4063 > 0f))));
let _e4071 = (0.5f * (_e4061 / select(1e-6f, _e4067, (_e4067 > 1e-6f))));
let _e4075 = (_e4057 + (_e4048 * _e4071));
let _e4076 = (_e4058 + (_e4050 * _e4071));
let _e4077 = (_e4059 + (_e4052 * _e4071));
let _e4081 = (_e4045 * _e4045);
let _e4083 = (_e4077 * _e4077);
let _e4091 = (((_e4059 <= 0f) || (_e4063 <= 0f)) || ((_e4077 <= 0f) || (_e4083 <= (_e4081 * (((_e4075 * _e4075) + (_e4076 * _e4076)) + _e4083)))));
let _e4105 = (_e161 + ((_e2711.member_4.x * _e3301.member_2) * _e4037));
let _e4106 = (_e172 + ((_e2711.member_4.y * _e3301.member_2) * _e4037));
let _e4107 = (_e183 + ((_e2711.member_4.z * _e3301.member_2) * _e4037));
let _e4109 = (_e4107 * _e4107);
let _e4118 = ((_e3096 & 1u) != 0u);
let _e4122 = select(_e4091, ((_e4107 <= 0f) || (_e4109 <= (_e4081 * (((_e4105 * _e4105) + (_e4106 * _e4106)) + _e4109)))), _e4118);
phi_6353_ = select(select(select(_e4077, _e4059, _e4091), _e4107, _e4118), _e183, _e4122);
phi_6354_ = select(select(select(_e4076, _e4058, _e4091), _e4106, _e4118), _e172, _e4122);
phi_6355_ = select(select(select(_e4075, _e4057, _e4091), _e4105, _e4118), _e161, _e4122);
phi_6356_ = select(1f, 0f, _e4122);
} else {
phi_6353_ = _e183;
phi_6354_ = _e172;
phi_6355_ = _e161;
phi_6356_ = 1f;
}
let _e4128 = phi_6353_;
let _e4130 = phi_6354_;
let _e4132 = phi_6355_;
let _e4134 = phi_6356_;
let _e4137 = (_e4033.member * _e4134);
global_5.member[_e118] = (_e129 * (_e4033.member_2.x * _e4137));
global_5.member[_e130] = (_e139 * (_e4033.member_2.y * _e4137));
global_5.member[_e141] = (_e150 * (_e4033.member_2.z * _e4137));
global_5.member[_e152] = _e4132;
global_5.member[_e163] = _e4130;
global_5.member[_e174] = _e4128;
global_5.member[_e185] = _e194;
global_5.member[_e196] = _e205;
global_5.member[_e207] = _e216;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
