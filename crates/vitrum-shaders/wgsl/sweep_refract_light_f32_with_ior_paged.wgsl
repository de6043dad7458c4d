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
struct type_15 {
member: array<u32>,
}
struct type_16 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_17 {
member: u32,
member_1: u32,
}
struct type_18 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_19 {
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
struct type_20 {
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
struct type_21 {
member: type_5,
member_1: type_5,
}
struct type_22 {
member: type_7,
member_1: u32,
}
struct type_23 {
member: type_2,
member_1: u32,
member_2: type_16,
member_3: type_17,
member_4: u32,
member_5: type_18,
member_6: type_19,
member_7: type_19,
member_8: type_20,
member_9: type_21,
member_10: f32,
member_11: type_18,
member_12: type_4,
member_13: type_9,
member_14: type_22,
member_15: type_22,
member_16: type_22,
member_17: type_22,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_24 {
member: type_23,
}
struct type_27 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_28 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_29 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_30 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_24;
@group(0) @binding(1)
var<storage> global_2: type_15;
@group(0) @binding(3)
var<storage> global_3: type_15;
@group(0) @binding(4)
var<storage> global_4: type_15;
@group(0) @binding(6)
var<storage, read_write> global_5: type_11;
@group(0) @binding(5)
var<storage> global_6: type_11;
@group(0) @binding(2)
var<storage> global_7: type_15;
fn function_() {
var local: type_27;
var local_1: vec3<f32>;
var local_2: type_27;
var local_3: vec3<f32>;
var local_4: type_27;
var local_5: vec3<f32>;
var local_6: type_27;
var local_7: vec3<f32>;
var phi_1246_: u32;
var phi_4625_: type_28;
var phi_5234_: type_29;
var phi_6030_: type_5;
var phi_7140_: type_30;
var phi_7292_: vec3<f32>;
var phi_7293_: f32;
let _e87 = global;
let _e90 = arrayLength((&global_2.member));
let _e97 = arrayLength((&global_4.member));
let _e99 = arrayLength((&global_6.member));
let _e104 = global_1.member.member_2;
let _e107 = global_1.member.member;
let _e115 = (_e87.x + _e104.member);
let _e117 = (_e87.y + _e104.member_1);
if (_e115 < _e104.member_2) {
if (_e117 < _e104.member_3) {
let _e120 = (_e107.member * _e107.member_1);
let _e122 = ((_e117 * _e107.member) + _e115);
let _e123 = bitcast<i32>(_e122);
let _e125 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e127 = select(_e125, _e123, (_e123 < _e125));
let _e133 = global_5.member[bitcast<u32>(select(0i, _e127, (_e127 > 0i)))];
let _e134 = (_e120 + _e122);
let _e135 = bitcast<i32>(_e134);
let _e137 = select(_e125, _e135, (_e135 < _e125));
let _e143 = global_5.member[bitcast<u32>(select(0i, _e137, (_e137 > 0i)))];
let _e145 = ((2u * _e120) + _e122);
let _e146 = bitcast<i32>(_e145);
let _e148 = select(_e125, _e146, (_e146 < _e125));
let _e154 = global_5.member[bitcast<u32>(select(0i, _e148, (_e148 > 0i)))];
let _e156 = ((3u * _e120) + _e122);
let _e157 = bitcast<i32>(_e156);
let _e159 = select(_e125, _e157, (_e157 < _e125));
let _e165 = global_5.member[bitcast<u32>(select(0i, _e159, (_e159 > 0i)))];
let _e167 = ((4u * _e120) + _e122);
let _e168 = bitcast<i32>(_e167);
let _e170 = select(_e125, _e168, (_e168 < _e125));
let _e176 = global_5.member[bitcast<u32>(select(0i, _e170, (_e170 > 0i)))];
let _e178 = ((5u * _e120) + _e122);
let _e179 = bitcast<i32>(_e178);
let _e181 = select(_e125, _e179, (_e179 < _e125));
let _e187 = global_5.member[bitcast<u32>(select(0i, _e181, (_e181 > 0i)))];
let _e189 = ((6u * _e120) + _e122);
let _e190 = bitcast<i32>(_e189);
let _e192 = select(_e125, _e190, (_e190 < _e125));
let _e198 = global_5.member[bitcast<u32>(select(0i, _e192, (_e192 > 0i)))];
let _e200 = ((7u * _e120) + _e122);
let _e201 = bitcast<i32>(_e200);
let _e203 = select(_e125, _e201, (_e201 < _e125));
let _e209 = global_5.member[bitcast<u32>(select(0i, _e203, (_e203 > 0i)))];
let _e211 = ((8u * _e120) + _e122);
let _e212 = bitcast<i32>(_e211);
let _e214 = select(_e125, _e212, (_e212 < _e125));
let _e220 = global_5.member[bitcast<u32>(select(0i, _e214, (_e214 > 0i)))];
let _e224 = global_1.member.member_8.member;
let _e228 = global_1.member.member_8.member_1;
let _e229 = (_e224 * _e228);
if (_e99 >= (_e229 * 2u)) {
let _e233 = bitcast<i32>((_e117 * _e224));
let _e235 = bitcast<i32>(_e115);
let _e240 = global_6.member[bitcast<u32>((_e233 + _e235))];
let _e246 = global_6.member[bitcast<u32>(((bitcast<i32>(_e229) + _e233) + _e235))];
let _e247 = f32(_e235);
let _e249 = f32(bitcast<i32>(_e117));
let _e255 = global_1.member.member_5.member;
let _e259 = global_1.member.member_8.member_8;
let _e260 = (_e255 - _e259);
let _e264 = global_1.member.member_8.member_2;
let _e268 = global_1.member.member_8.member_6;
let _e275 = global_1.member.member_8.member_4;
let _e277 = ((_e264 + (_e268 * _e260)) + (((_e247 - _e240) + 0.5f) * _e275));
let _e281 = global_1.member.member_8.member_3;
let _e285 = global_1.member.member_8.member_7;
let _e290 = ((_e281 + (_e285 * _e260)) + (((_e249 - _e246) + 0.5f) * _e275));
let _e294 = global_1.member.member_5.member_1;
let _e295 = (_e294 - _e259);
let _e300 = ((_e264 + (_e268 * _e295)) + ((_e247 + 0.5f) * _e275));
let _e305 = ((_e281 + (_e285 * _e295)) + ((_e249 + 0.5f) * _e275));
let _e309 = global_1.member.member_6.member;
let _e320 = ((((_e309.member.member * _e277) + (_e309.member.member_1 * _e290)) + (_e309.member.member_2 * _e255)) + _e309.member_1);
let _e324 = global_1.member.member_6.member_1;
let _e335 = ((((_e324.member.member * _e277) + (_e324.member.member_1 * _e290)) + (_e324.member.member_2 * _e255)) + _e324.member_1);
let _e339 = global_1.member.member_6.member_2;
let _e350 = ((((_e339.member.member * _e277) + (_e339.member.member_1 * _e290)) + (_e339.member.member_2 * _e255)) + _e339.member_1);
let _e356 = ((((_e309.member.member * _e300) + (_e309.member.member_1 * _e305)) + (_e309.member.member_2 * _e294)) + _e309.member_1);
let _e362 = ((((_e324.member.member * _e300) + (_e324.member.member_1 * _e305)) + (_e324.member.member_2 * _e294)) + _e324.member_1);
let _e368 = ((((_e339.member.member * _e300) + (_e339.member.member_1 * _e305)) + (_e339.member.member_2 * _e294)) + _e339.member_1);
let _e374 = global_1.member.member_6.member_3.member;
let _e375 = (_e374 - 1f);
let _e384 = global_1.member.member_6.member_3.member_1;
let _e385 = (_e384 - 1f);
let _e394 = global_1.member.member_6.member_3.member_2;
let _e395 = (_e394 - 1f);
let _e414 = global_1.member.member_6.member_4;
let _e415 = (_e374 - 0.5f);
let _e417 = select(-0.5f, _e356, (_e356 > -0.5f));
let _e419 = select(_e415, _e417, (_e417 < _e415));
let _e420 = (_e384 - 0.5f);
let _e422 = select(-0.5f, _e362, (_e362 > -0.5f));
let _e424 = select(_e420, _e422, (_e422 < _e420));
let _e425 = (_e394 - 0.5f);
let _e427 = select(-0.5f, _e368, (_e368 > -0.5f));
let _e429 = select(_e425, _e427, (_e427 < _e425));
let _e435 = bitcast<f32>((bitcast<u32>((_e356 - _e320)) & 2147483647u));
let _e438 = bitcast<f32>((bitcast<u32>((_e362 - _e335)) & 2147483647u));
let _e440 = select(_e438, _e435, (_e435 > _e438));
let _e443 = bitcast<f32>((bitcast<u32>((_e368 - _e350)) & 2147483647u));
let _e452 = bitcast<f32>((bitcast<u32>((_e356 - _e419)) & 2147483647u));
let _e455 = bitcast<f32>((bitcast<u32>((_e362 - _e424)) & 2147483647u));
let _e457 = select(_e455, _e452, (_e452 > _e455));
let _e460 = bitcast<f32>((bitcast<u32>((_e368 - _e429)) & 2147483647u));
let _e464 = (_e419 + 0.5f);
let _e466 = select(0f, _e464, (_e464 > 0f));
let _e468 = select(_e375, _e466, (_e466 < _e375));
let _e475 = select(0i, select(select(i32(_e468), i32(-2147483648), (_e468 < -2147483600f)), 2147483647i, (_e468 > 2147483500f)), (_e468 == _e468));
let _e483 = global_1.member.member_6.member_12;
let _e484 = (_e483 & 31u);
let _e487 = (_e424 + 0.5f);
let _e489 = select(0f, _e487, (_e487 > 0f));
let _e491 = select(_e385, _e489, (_e489 < _e385));
let _e498 = select(0i, select(select(i32(_e491), i32(-2147483648), (_e491 < -2147483600f)), 2147483647i, (_e491 > 2147483500f)), (_e491 == _e491));
let _e505 = (_e429 + 0.5f);
let _e507 = select(0f, _e505, (_e505 > 0f));
let _e509 = select(_e395, _e507, (_e507 < _e395));
let _e516 = select(0i, select(select(i32(_e509), i32(-2147483648), (_e509 < -2147483600f)), 2147483647i, (_e509 > 2147483500f)), (_e509 == _e509));
let _e527 = global_1.member.member_6.member_9.member;
let _e533 = global_1.member.member_6.member_9.member_1;
let _e538 = global_1.member.member_6.member_10;
let _e544 = ((bitcast<i32>(_e538) + ((_e475 - select(0i, 1i, (_e468 < f32(_e475)))) >> bitcast<u32>(_e484))) + (bitcast<i32>(_e527) * (((_e498 - select(0i, 1i, (_e491 < f32(_e498)))) >> bitcast<u32>(_e484)) + (bitcast<i32>(_e533) * ((_e516 - select(0i, 1i, (_e509 < f32(_e516)))) >> bitcast<u32>(_e484))))));
let _e546 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e548 = select(_e546, _e544, (_e544 < _e546));
let _e554 = global_3.member[bitcast<u32>(select(0i, _e548, (_e548 > 0i)))];
let _e561 = global_1.member.member_7.member;
let _e576 = global_1.member.member_7.member_1;
let _e591 = global_1.member.member_7.member_2;
let _e608 = ((((_e561.member.member * _e300) + (_e561.member.member_1 * _e305)) + (_e561.member.member_2 * _e294)) + _e561.member_1);
let _e614 = ((((_e576.member.member * _e300) + (_e576.member.member_1 * _e305)) + (_e576.member.member_2 * _e294)) + _e576.member_1);
let _e620 = ((((_e591.member.member * _e300) + (_e591.member.member_1 * _e305)) + (_e591.member.member_2 * _e294)) + _e591.member_1);
let _e624 = global_1.member.member_7.member_4;
let _e629 = global_1.member.member_7.member_3.member;
let _e630 = (_e629 - 0.5f);
let _e632 = select(-0.5f, _e608, (_e608 > -0.5f));
let _e634 = select(_e630, _e632, (_e632 < _e630));
let _e639 = global_1.member.member_7.member_3.member_1;
let _e640 = (_e639 - 0.5f);
let _e642 = select(-0.5f, _e614, (_e614 > -0.5f));
let _e644 = select(_e640, _e642, (_e642 < _e640));
let _e649 = global_1.member.member_7.member_3.member_2;
let _e650 = (_e649 - 0.5f);
let _e652 = select(-0.5f, _e620, (_e620 > -0.5f));
let _e654 = select(_e650, _e652, (_e652 < _e650));
let _e660 = bitcast<f32>((bitcast<u32>((_e608 - ((((_e561.member.member * _e277) + (_e561.member.member_1 * _e290)) + (_e561.member.member_2 * _e255)) + _e561.member_1))) & 2147483647u));
let _e663 = bitcast<f32>((bitcast<u32>((_e614 - ((((_e576.member.member * _e277) + (_e576.member.member_1 * _e290)) + (_e576.member.member_2 * _e255)) + _e576.member_1))) & 2147483647u));
let _e665 = select(_e663, _e660, (_e660 > _e663));
let _e668 = bitcast<f32>((bitcast<u32>((_e620 - ((((_e591.member.member * _e277) + (_e591.member.member_1 * _e290)) + (_e591.member.member_2 * _e255)) + _e591.member_1))) & 2147483647u));
let _e677 = bitcast<f32>((bitcast<u32>((_e608 - _e634)) & 2147483647u));
let _e680 = bitcast<f32>((bitcast<u32>((_e614 - _e644)) & 2147483647u));
let _e682 = select(_e680, _e677, (_e677 > _e680));
let _e685 = bitcast<f32>((bitcast<u32>((_e620 - _e654)) & 2147483647u));
let _e689 = (_e634 + 0.5f);
let _e690 = (_e629 - 1f);
let _e692 = select(0f, _e689, (_e689 > 0f));
let _e694 = select(_e690, _e692, (_e692 < _e690));
let _e701 = select(0i, select(select(i32(_e694), i32(-2147483648), (_e694 < -2147483600f)), 2147483647i, (_e694 > 2147483500f)), (_e694 == _e694));
let _e709 = global_1.member.member_7.member_12;
let _e710 = (_e709 & 31u);
let _e713 = (_e644 + 0.5f);
let _e714 = (_e639 - 1f);
let _e716 = select(0f, _e713, (_e713 > 0f));
let _e718 = select(_e714, _e716, (_e716 < _e714));
let _e725 = select(0i, select(select(i32(_e718), i32(-2147483648), (_e718 < -2147483600f)), 2147483647i, (_e718 > 2147483500f)), (_e718 == _e718));
let _e732 = (_e654 + 0.5f);
let _e733 = (_e649 - 1f);
let _e735 = select(0f, _e732, (_e732 > 0f));
let _e737 = select(_e733, _e735, (_e735 < _e733));
let _e744 = select(0i, select(select(i32(_e737), i32(-2147483648), (_e737 < -2147483600f)), 2147483647i, (_e737 > 2147483500f)), (_e737 == _e737));
let _e755 = global_1.member.member_7.member_9.member;
let _e761 = global_1.member.member_7.member_9.member_1;
let _e766 = global_1.member.member_7.member_10;
let _e772 = ((bitcast<i32>(_e766) + ((_e701 - select(0i, 1i, (_e694 < f32(_e701)))) >> bitcast<u32>(_e710))) + (bitcast<i32>(_e755) * (((_e725 - select(0i, 1i, (_e718 < f32(_e725)))) >> bitcast<u32>(_e710)) + (bitcast<i32>(_e761) * ((_e744 - select(0i, 1i, (_e737 < f32(_e744)))) >> bitcast<u32>(_e710))))));
let _e774 = select(_e546, _e772, (_e772 < _e546));
let _e780 = global_3.member[bitcast<u32>(select(0i, _e774, (_e774 > 0i)))];
let _e786 = global_1.member.member_1;
phi_1246_ = select(select(7u, 3u, (((((((_e320 >= 0f) && (_e320 <= _e375)) && (_e335 >= 0f)) && (_e335 <= _e385)) && (_e350 >= 0f)) && (_e350 <= _e395)) && ((((((_e356 >= 0f) && (_e356 <= _e375)) && (_e362 >= 0f)) && (_e362 <= _e385)) && (_e368 >= 0f)) && (_e368 <= _e395)))), 1u, (((_e786 & 64u) != 0u) || ((((select(_e443, _e440, (_e440 > _e443)) <= _e414) && ((select(_e460, _e457, (_e457 > _e460)) > _e414) || (_e554 != 0u))) && ((select(_e668, _e665, (_e665 > _e668)) <= _e624) && ((select(_e685, _e682, (_e682 > _e685)) > _e624) || (_e780 != 0u)))) && ((_e786 & 32u) != 0u))));
} else {
phi_1246_ = 7u;
}
let _e796 = phi_1246_;
if (_e796 > 1u) {
let _e802 = bitcast<i32>(((_e117 * _e224) + _e115));
let _e805 = (bitcast<i32>(_e99) - 1i);
let _e807 = select(_e805, _e802, (_e802 < _e805));
let _e813 = global_6.member[bitcast<u32>(select(0i, _e807, (_e807 > 0i)))];
let _e814 = (bitcast<i32>(_e229) + _e802);
let _e816 = select(_e805, _e814, (_e814 < _e805));
let _e822 = global_6.member[bitcast<u32>(select(0i, _e816, (_e816 > 0i)))];
let _e824 = f32(bitcast<i32>(_e115));
let _e826 = f32(bitcast<i32>(_e117));
let _e832 = global_1.member.member_5.member;
let _e836 = global_1.member.member_8.member_8;
let _e837 = (_e832 - _e836);
let _e841 = global_1.member.member_8.member_2;
let _e845 = global_1.member.member_8.member_6;
let _e852 = global_1.member.member_8.member_4;
let _e854 = ((_e841 + (_e845 * _e837)) + (((_e824 - _e813) + 0.5f) * _e852));
let _e858 = global_1.member.member_8.member_3;
let _e862 = global_1.member.member_8.member_7;
let _e867 = ((_e858 + (_e862 * _e837)) + (((_e826 - _e822) + 0.5f) * _e852));
let _e871 = global_1.member.member_5.member_1;
let _e872 = (_e871 - _e836);
let _e877 = ((_e841 + (_e845 * _e872)) + ((_e824 + 0.5f) * _e852));
let _e882 = ((_e858 + (_e862 * _e872)) + ((_e826 + 0.5f) * _e852));
let _e886 = global_1.member.member_6.member;
let _e897 = ((((_e886.member.member * _e854) + (_e886.member.member_1 * _e867)) + (_e886.member.member_2 * _e832)) + _e886.member_1);
let _e901 = global_1.member.member_6.member_1;
let _e912 = ((((_e901.member.member * _e854) + (_e901.member.member_1 * _e867)) + (_e901.member.member_2 * _e832)) + _e901.member_1);
let _e916 = global_1.member.member_6.member_2;
let _e927 = ((((_e916.member.member * _e854) + (_e916.member.member_1 * _e867)) + (_e916.member.member_2 * _e832)) + _e916.member_1);
let _e933 = ((((_e886.member.member * _e877) + (_e886.member.member_1 * _e882)) + (_e886.member.member_2 * _e871)) + _e886.member_1);
let _e939 = ((((_e901.member.member * _e877) + (_e901.member.member_1 * _e882)) + (_e901.member.member_2 * _e871)) + _e901.member_1);
let _e945 = ((((_e916.member.member * _e877) + (_e916.member.member_1 * _e882)) + (_e916.member.member_2 * _e871)) + _e916.member_1);
let _e949 = global_1.member.member_7.member;
let _e960 = ((((_e949.member.member * _e877) + (_e949.member.member_1 * _e882)) + (_e949.member.member_2 * _e871)) + _e949.member_1);
let _e964 = global_1.member.member_7.member_1;
let _e975 = ((((_e964.member.member * _e877) + (_e964.member.member_1 * _e882)) + (_e964.member.member_2 * _e871)) + _e964.member_1);
let _e979 = global_1.member.member_7.member_2;
let _e990 = ((((_e979.member.member * _e877) + (_e979.member.member_1 * _e882)) + (_e979.member.member_2 * _e871)) + _e979.member_1);
let _e992 = (_e107.member_2 == 2u);
let _e995 = (((_e107.member_2 == 1u) || _e992) || (_e107.member_2 == 5u));
if _e995 {
let _e1000 = global_1.member.member_6.member_3.member;
let _e1001 = (_e1000 - 0.5f);
let _e1003 = select(-0.5f, _e933, (_e933 > -0.5f));
let _e1005 = select(_e1001, _e1003, (_e1003 < _e1001));
let _e1010 = global_1.member.member_6.member_3.member_1;
let _e1011 = (_e1010 - 0.5f);
let _e1013 = select(-0.5f, _e939, (_e939 > -0.5f));
let _e1015 = select(_e1011, _e1013, (_e1013 < _e1011));
let _e1020 = global_1.member.member_6.member_3.member_2;
let _e1021 = (_e1020 - 0.5f);
let _e1023 = select(-0.5f, _e945, (_e945 > -0.5f));
let _e1025 = select(_e1021, _e1023, (_e1023 < _e1021));
let _e1027 = select(-1f, _e1005, (_e1005 > -1f));
let _e1029 = select(_e1000, _e1027, (_e1027 < _e1000));
let _e1036 = select(0i, select(select(i32(_e1029), i32(-2147483648), (_e1029 < -2147483600f)), 2147483647i, (_e1029 > 2147483500f)), (_e1029 == _e1029));
let _e1040 = (_e1036 - select(0i, 1i, (_e1029 < f32(_e1036))));
let _e1042 = select(-1f, _e1015, (_e1015 > -1f));
let _e1044 = select(_e1010, _e1042, (_e1042 < _e1010));
let _e1051 = select(0i, select(select(i32(_e1044), i32(-2147483648), (_e1044 < -2147483600f)), 2147483647i, (_e1044 > 2147483500f)), (_e1044 == _e1044));
let _e1055 = (_e1051 - select(0i, 1i, (_e1044 < f32(_e1051))));
let _e1057 = select(-1f, _e1025, (_e1025 > -1f));
let _e1059 = select(_e1020, _e1057, (_e1057 < _e1020));
let _e1066 = select(0i, select(select(i32(_e1059), i32(-2147483648), (_e1059 < -2147483600f)), 2147483647i, (_e1059 > 2147483500f)), (_e1059 == _e1059));
let _e1070 = (_e1066 - select(0i, 1i, (_e1059 < f32(_e1066))));
let _e1074 = global_1.member.member_6.member_7;
let _e1078 = global_1.member.member_6.member_8;
let _e1079 = (_e1040 + 1i);
let _e1080 = (_e1055 + 1i);
let _e1081 = (_e1070 + 1i);
let _e1086 = global_1.member.member_6.member_11.member;
let _e1092 = global_1.member.member_6.member_11.member_1;
let _e1103 = ((_e1079 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1086) * ((_e1080 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1092) * (_e1081 >> bitcast<u32>(4i))))));
let _e1105 = (bitcast<i32>(_e90) - 1i);
let _e1107 = select(_e1105, _e1103, (_e1103 < _e1105));
let _e1113 = global_2.member[bitcast<u32>(select(0i, _e1107, (_e1107 > 0i)))];
let _e1115 = (_e1079 & 15i);
let _e1118 = ((_e1080 & 15i) * _e1074);
let _e1120 = (bitcast<i32>(_e1113) + ((_e1081 & 15i) * _e1078));
let _e1124 = (_e1118 + _e1074);
let _e1126 = (_e1118 + (2i * _e1074));
let _e1127 = (_e1120 + _e1078);
let _e1129 = (_e1120 + (2i * _e1078));
local_6 = type_27(array<i32, 4>(_e1115, (_e1115 + 1i), (_e1115 + 2i), (_e1115 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_7 = vec3<f32>((_e1005 - f32(_e1040)), (_e1015 - f32(_e1055)), (_e1025 - f32(_e1070)));
let _e1140 = (_e1127 + _e1124);
let _e1143 = local_6.member[1u];
let _e1144 = (_e1140 + _e1143);
let _e1146 = select(_e1105, _e1144, (_e1144 < _e1105));
let _e1151 = global_2.member[bitcast<u32>(select(0i, _e1146, (_e1146 > 0i)))];
let _e1152 = bitcast<f32>(_e1151);
let _e1155 = local_6.member[2u];
let _e1156 = (_e1140 + _e1155);
let _e1158 = select(_e1105, _e1156, (_e1156 < _e1105));
let _e1163 = global_2.member[bitcast<u32>(select(0i, _e1158, (_e1158 > 0i)))];
let _e1165 = local_7[0u];
let _e1168 = (_e1152 + ((bitcast<f32>(_e1163) - _e1152) * _e1165));
let _e1169 = (_e1127 + _e1126);
let _e1170 = local_6.member[1u];
let _e1171 = (_e1169 + _e1170);
let _e1173 = select(_e1105, _e1171, (_e1171 < _e1105));
let _e1178 = global_2.member[bitcast<u32>(select(0i, _e1173, (_e1173 > 0i)))];
let _e1179 = bitcast<f32>(_e1178);
let _e1180 = local_6.member[2u];
let _e1181 = (_e1169 + _e1180);
let _e1183 = select(_e1105, _e1181, (_e1181 < _e1105));
let _e1188 = global_2.member[bitcast<u32>(select(0i, _e1183, (_e1183 > 0i)))];
let _e1190 = local_7[0u];
let _e1194 = (_e1129 + _e1124);
let _e1195 = local_6.member[1u];
let _e1196 = (_e1194 + _e1195);
let _e1198 = select(_e1105, _e1196, (_e1196 < _e1105));
let _e1203 = global_2.member[bitcast<u32>(select(0i, _e1198, (_e1198 > 0i)))];
let _e1204 = bitcast<f32>(_e1203);
let _e1205 = local_6.member[2u];
let _e1206 = (_e1194 + _e1205);
let _e1208 = select(_e1105, _e1206, (_e1206 < _e1105));
let _e1213 = global_2.member[bitcast<u32>(select(0i, _e1208, (_e1208 > 0i)))];
let _e1215 = local_7[0u];
let _e1218 = (_e1204 + ((bitcast<f32>(_e1213) - _e1204) * _e1215));
let _e1219 = (_e1129 + _e1126);
let _e1220 = local_6.member[1u];
let _e1221 = (_e1219 + _e1220);
let _e1223 = select(_e1105, _e1221, (_e1221 < _e1105));
let _e1228 = global_2.member[bitcast<u32>(select(0i, _e1223, (_e1223 > 0i)))];
let _e1229 = bitcast<f32>(_e1228);
let _e1230 = local_6.member[2u];
let _e1231 = (_e1219 + _e1230);
let _e1233 = select(_e1105, _e1231, (_e1231 < _e1105));
let _e1238 = global_2.member[bitcast<u32>(select(0i, _e1233, (_e1233 > 0i)))];
let _e1240 = local_7[0u];
let _e1245 = local_7[1u];
let _e1248 = (_e1168 + (((_e1179 + ((bitcast<f32>(_e1188) - _e1179) * _e1190)) - _e1168) * _e1245));
let _e1249 = local_7[1u];
let _e1254 = local_7[2u];
let _e1261 = global_1.member.member_6.member_5;
let _e1266 = global_1.member.member_6.member_6;
let _e1267 = (((_e1248 + (((_e1218 + (((_e1229 + ((bitcast<f32>(_e1238) - _e1229) * _e1240)) - _e1218) * _e1249)) - _e1248) * _e1254)) * _e1261) + _e1266);
let _e1269 = select(0f, _e1267, (_e1267 > 0f));
let _e1276 = global_1.member.member_7.member_3.member;
let _e1277 = (_e1276 - 0.5f);
let _e1279 = select(-0.5f, _e960, (_e960 > -0.5f));
let _e1281 = select(_e1277, _e1279, (_e1279 < _e1277));
let _e1286 = global_1.member.member_7.member_3.member_1;
let _e1287 = (_e1286 - 0.5f);
let _e1289 = select(-0.5f, _e975, (_e975 > -0.5f));
let _e1291 = select(_e1287, _e1289, (_e1289 < _e1287));
let _e1296 = global_1.member.member_7.member_3.member_2;
let _e1297 = (_e1296 - 0.5f);
let _e1299 = select(-0.5f, _e990, (_e990 > -0.5f));
let _e1301 = select(_e1297, _e1299, (_e1299 < _e1297));
let _e1303 = select(-1f, _e1281, (_e1281 > -1f));
let _e1305 = select(_e1276, _e1303, (_e1303 < _e1276));
let _e1312 = select(0i, select(select(i32(_e1305), i32(-2147483648), (_e1305 < -2147483600f)), 2147483647i, (_e1305 > 2147483500f)), (_e1305 == _e1305));
let _e1316 = (_e1312 - select(0i, 1i, (_e1305 < f32(_e1312))));
let _e1318 = select(-1f, _e1291, (_e1291 > -1f));
let _e1320 = select(_e1286, _e1318, (_e1318 < _e1286));
let _e1327 = select(0i, select(select(i32(_e1320), i32(-2147483648), (_e1320 < -2147483600f)), 2147483647i, (_e1320 > 2147483500f)), (_e1320 == _e1320));
let _e1331 = (_e1327 - select(0i, 1i, (_e1320 < f32(_e1327))));
let _e1333 = select(-1f, _e1301, (_e1301 > -1f));
let _e1335 = select(_e1296, _e1333, (_e1333 < _e1296));
let _e1342 = select(0i, select(select(i32(_e1335), i32(-2147483648), (_e1335 < -2147483600f)), 2147483647i, (_e1335 > 2147483500f)), (_e1335 == _e1335));
let _e1346 = (_e1342 - select(0i, 1i, (_e1335 < f32(_e1342))));
let _e1350 = global_1.member.member_7.member_7;
let _e1354 = global_1.member.member_7.member_8;
let _e1355 = (_e1316 + 1i);
let _e1356 = (_e1331 + 1i);
let _e1357 = (_e1346 + 1i);
let _e1362 = global_1.member.member_7.member_11.member;
let _e1368 = global_1.member.member_7.member_11.member_1;
let _e1379 = ((_e1355 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1362) * ((_e1356 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1368) * (_e1357 >> bitcast<u32>(4i))))));
let _e1381 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1383 = select(_e1381, _e1379, (_e1379 < _e1381));
let _e1389 = global_7.member[bitcast<u32>(select(0i, _e1383, (_e1383 > 0i)))];
let _e1391 = (_e1355 & 15i);
let _e1394 = ((_e1356 & 15i) * _e1350);
let _e1396 = (bitcast<i32>(_e1389) + ((_e1357 & 15i) * _e1354));
let _e1400 = (_e1394 + _e1350);
let _e1402 = (_e1394 + (2i * _e1350));
let _e1404 = (_e1394 + (3i * _e1350));
let _e1405 = (_e1396 + _e1354);
let _e1407 = (_e1396 + (2i * _e1354));
let _e1409 = (_e1396 + (3i * _e1354));
local_4 = type_27(array<i32, 4>(_e1391, (_e1391 + 1i), (_e1391 + 2i), (_e1391 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e1281 - f32(_e1316)), (_e1291 - f32(_e1331)), (_e1301 - f32(_e1346)));
let _e1420 = (_e1405 + _e1400);
let _e1423 = local_4.member[0u];
let _e1424 = (_e1420 + _e1423);
let _e1426 = select(_e1381, _e1424, (_e1424 < _e1381));
let _e1431 = global_7.member[bitcast<u32>(select(0i, _e1426, (_e1426 > 0i)))];
let _e1432 = bitcast<f32>(_e1431);
let _e1435 = local_4.member[1u];
let _e1436 = (_e1420 + _e1435);
let _e1438 = select(_e1381, _e1436, (_e1436 < _e1381));
let _e1443 = global_7.member[bitcast<u32>(select(0i, _e1438, (_e1438 > 0i)))];
let _e1444 = bitcast<f32>(_e1443);
let _e1447 = local_4.member[2u];
let _e1448 = (_e1420 + _e1447);
let _e1450 = select(_e1381, _e1448, (_e1448 < _e1381));
let _e1455 = global_7.member[bitcast<u32>(select(0i, _e1450, (_e1450 > 0i)))];
let _e1456 = bitcast<f32>(_e1455);
let _e1459 = local_4.member[3u];
let _e1460 = (_e1420 + _e1459);
let _e1462 = select(_e1381, _e1460, (_e1460 < _e1381));
let _e1467 = global_7.member[bitcast<u32>(select(0i, _e1462, (_e1462 > 0i)))];
let _e1469 = local_5[0u];
let _e1472 = (_e1432 + ((_e1444 - _e1432) * _e1469));
let _e1473 = local_5[0u];
let _e1476 = (_e1444 + ((_e1456 - _e1444) * _e1473));
let _e1477 = local_5[0u];
let _e1480 = (_e1456 + ((bitcast<f32>(_e1467) - _e1456) * _e1477));
let _e1481 = (_e1405 + _e1402);
let _e1482 = local_4.member[0u];
let _e1483 = (_e1481 + _e1482);
let _e1485 = select(_e1381, _e1483, (_e1483 < _e1381));
let _e1490 = global_7.member[bitcast<u32>(select(0i, _e1485, (_e1485 > 0i)))];
let _e1491 = bitcast<f32>(_e1490);
let _e1492 = local_4.member[1u];
let _e1493 = (_e1481 + _e1492);
let _e1495 = select(_e1381, _e1493, (_e1493 < _e1381));
let _e1500 = global_7.member[bitcast<u32>(select(0i, _e1495, (_e1495 > 0i)))];
let _e1501 = bitcast<f32>(_e1500);
let _e1502 = local_4.member[2u];
let _e1503 = (_e1481 + _e1502);
let _e1505 = select(_e1381, _e1503, (_e1503 < _e1381));
let _e1510 = global_7.member[bitcast<u32>(select(0i, _e1505, (_e1505 > 0i)))];
let _e1511 = bitcast<f32>(_e1510);
let _e1512 = local_4.member[3u];
let _e1513 = (_e1481 + _e1512);
let _e1515 = select(_e1381, _e1513, (_e1513 < _e1381));
let _e1520 = global_7.member[bitcast<u32>(select(0i, _e1515, (_e1515 > 0i)))];
let _e1522 = local_5[0u];
let _e1526 = local_5[0u];
let _e1529 = (_e1501 + ((_e1511 - _e1501) * _e1526));
let _e1530 = local_5[0u];
let _e1534 = (_e1407 + _e1400);
let _e1535 = local_4.member[0u];
let _e1536 = (_e1534 + _e1535);
let _e1538 = select(_e1381, _e1536, (_e1536 < _e1381));
let _e1543 = global_7.member[bitcast<u32>(select(0i, _e1538, (_e1538 > 0i)))];
let _e1544 = bitcast<f32>(_e1543);
let _e1545 = local_4.member[1u];
let _e1546 = (_e1534 + _e1545);
let _e1548 = select(_e1381, _e1546, (_e1546 < _e1381));
let _e1553 = global_7.member[bitcast<u32>(select(0i, _e1548, (_e1548 > 0i)))];
let _e1554 = bitcast<f32>(_e1553);
let _e1555 = local_4.member[2u];
let _e1556 = (_e1534 + _e1555);
let _e1558 = select(_e1381, _e1556, (_e1556 < _e1381));
let _e1563 = global_7.member[bitcast<u32>(select(0i, _e1558, (_e1558 > 0i)))];
let _e1564 = bitcast<f32>(_e1563);
let _e1565 = local_4.member[3u];
let _e1566 = (_e1534 + _e1565);
let _e1568 = select(_e1381, _e1566, (_e1566 < _e1381));
let _e1573 = global_7.member[bitcast<u32>(select(0i, _e1568, (_e1568 > 0i)))];
let _e1575 = local_5[0u];
let _e1578 = (_e1544 + ((_e1554 - _e1544) * _e1575));
let _e1579 = local_5[0u];
let _e1582 = (_e1554 + ((_e1564 - _e1554) * _e1579));
let _e1583 = local_5[0u];
let _e1586 = (_e1564 + ((bitcast<f32>(_e1573) - _e1564) * _e1583));
let _e1587 = (_e1407 + _e1402);
let _e1588 = local_4.member[0u];
let _e1589 = (_e1587 + _e1588);
let _e1591 = select(_e1381, _e1589, (_e1589 < _e1381));
let _e1596 = global_7.member[bitcast<u32>(select(0i, _e1591, (_e1591 > 0i)))];
let _e1597 = bitcast<f32>(_e1596);
let _e1598 = local_4.member[1u];
let _e1599 = (_e1587 + _e1598);
let _e1601 = select(_e1381, _e1599, (_e1599 < _e1381));
let _e1606 = global_7.member[bitcast<u32>(select(0i, _e1601, (_e1601 > 0i)))];
let _e1607 = bitcast<f32>(_e1606);
let _e1608 = local_4.member[2u];
let _e1609 = (_e1587 + _e1608);
let _e1611 = select(_e1381, _e1609, (_e1609 < _e1381));
let _e1616 = global_7.member[bitcast<u32>(select(0i, _e1611, (_e1611 > 0i)))];
let _e1617 = bitcast<f32>(_e1616);
let _e1618 = local_4.member[3u];
let _e1619 = (_e1587 + _e1618);
let _e1621 = select(_e1381, _e1619, (_e1619 < _e1381));
let _e1626 = global_7.member[bitcast<u32>(select(0i, _e1621, (_e1621 > 0i)))];
let _e1628 = local_5[0u];
let _e1632 = local_5[0u];
let _e1635 = (_e1607 + ((_e1617 - _e1607) * _e1632));
let _e1636 = local_5[0u];
let _e1640 = (_e1405 + _e1394);
let _e1641 = local_4.member[1u];
let _e1642 = (_e1640 + _e1641);
let _e1644 = select(_e1381, _e1642, (_e1642 < _e1381));
let _e1649 = global_7.member[bitcast<u32>(select(0i, _e1644, (_e1644 > 0i)))];
let _e1650 = bitcast<f32>(_e1649);
let _e1651 = local_4.member[2u];
let _e1652 = (_e1640 + _e1651);
let _e1654 = select(_e1381, _e1652, (_e1652 < _e1381));
let _e1659 = global_7.member[bitcast<u32>(select(0i, _e1654, (_e1654 > 0i)))];
let _e1661 = local_5[0u];
let _e1664 = (_e1650 + ((bitcast<f32>(_e1659) - _e1650) * _e1661));
let _e1665 = (_e1405 + _e1404);
let _e1666 = local_4.member[1u];
let _e1667 = (_e1665 + _e1666);
let _e1669 = select(_e1381, _e1667, (_e1667 < _e1381));
let _e1674 = global_7.member[bitcast<u32>(select(0i, _e1669, (_e1669 > 0i)))];
let _e1675 = bitcast<f32>(_e1674);
let _e1676 = local_4.member[2u];
let _e1677 = (_e1665 + _e1676);
let _e1679 = select(_e1381, _e1677, (_e1677 < _e1381));
let _e1684 = global_7.member[bitcast<u32>(select(0i, _e1679, (_e1679 > 0i)))];
let _e1686 = local_5[0u];
let _e1690 = (_e1407 + _e1394);
let _e1691 = local_4.member[1u];
let _e1692 = (_e1690 + _e1691);
let _e1694 = select(_e1381, _e1692, (_e1692 < _e1381));
let _e1699 = global_7.member[bitcast<u32>(select(0i, _e1694, (_e1694 > 0i)))];
let _e1700 = bitcast<f32>(_e1699);
let _e1701 = local_4.member[2u];
let _e1702 = (_e1690 + _e1701);
let _e1704 = select(_e1381, _e1702, (_e1702 < _e1381));
let _e1709 = global_7.member[bitcast<u32>(select(0i, _e1704, (_e1704 > 0i)))];
let _e1711 = local_5[0u];
let _e1714 = (_e1700 + ((bitcast<f32>(_e1709) - _e1700) * _e1711));
let _e1715 = (_e1407 + _e1404);
let _e1716 = local_4.member[1u];
let _e1717 = (_e1715 + _e1716);
let _e1719 = select(_e1381, _e1717, (_e1717 < _e1381));
let _e1724 = global_7.member[bitcast<u32>(select(0i, _e1719, (_e1719 > 0i)))];
let _e1725 = bitcast<f32>(_e1724);
let _e1726 = local_4.member[2u];
let _e1727 = (_e1715 + _e1726);
let _e1729 = select(_e1381, _e1727, (_e1727 < _e1381));
let _e1734 = global_7.member[bitcast<u32>(select(0i, _e1729, (_e1729 > 0i)))];
let _e1736 = local_5[0u];
let _e1740 = (_e1396 + _e1400);
let _e1741 = local_4.member[1u];
let _e1742 = (_e1740 + _e1741);
let _e1744 = select(_e1381, _e1742, (_e1742 < _e1381));
let _e1749 = global_7.member[bitcast<u32>(select(0i, _e1744, (_e1744 > 0i)))];
let _e1750 = bitcast<f32>(_e1749);
let _e1751 = local_4.member[2u];
let _e1752 = (_e1740 + _e1751);
let _e1754 = select(_e1381, _e1752, (_e1752 < _e1381));
let _e1759 = global_7.member[bitcast<u32>(select(0i, _e1754, (_e1754 > 0i)))];
let _e1761 = local_5[0u];
let _e1764 = (_e1750 + ((bitcast<f32>(_e1759) - _e1750) * _e1761));
let _e1765 = (_e1409 + _e1400);
let _e1766 = local_4.member[1u];
let _e1767 = (_e1765 + _e1766);
let _e1769 = select(_e1381, _e1767, (_e1767 < _e1381));
let _e1774 = global_7.member[bitcast<u32>(select(0i, _e1769, (_e1769 > 0i)))];
let _e1775 = bitcast<f32>(_e1774);
let _e1776 = local_4.member[2u];
let _e1777 = (_e1765 + _e1776);
let _e1779 = select(_e1381, _e1777, (_e1777 < _e1381));
let _e1784 = global_7.member[bitcast<u32>(select(0i, _e1779, (_e1779 > 0i)))];
let _e1786 = local_5[0u];
let _e1789 = (_e1775 + ((bitcast<f32>(_e1784) - _e1775) * _e1786));
let _e1790 = (_e1396 + _e1402);
let _e1791 = local_4.member[1u];
let _e1792 = (_e1790 + _e1791);
let _e1794 = select(_e1381, _e1792, (_e1792 < _e1381));
let _e1799 = global_7.member[bitcast<u32>(select(0i, _e1794, (_e1794 > 0i)))];
let _e1800 = bitcast<f32>(_e1799);
let _e1801 = local_4.member[2u];
let _e1802 = (_e1790 + _e1801);
let _e1804 = select(_e1381, _e1802, (_e1802 < _e1381));
let _e1809 = global_7.member[bitcast<u32>(select(0i, _e1804, (_e1804 > 0i)))];
let _e1811 = local_5[0u];
let _e1815 = (_e1409 + _e1402);
let _e1816 = local_4.member[1u];
let _e1817 = (_e1815 + _e1816);
let _e1819 = select(_e1381, _e1817, (_e1817 < _e1381));
let _e1824 = global_7.member[bitcast<u32>(select(0i, _e1819, (_e1819 > 0i)))];
let _e1825 = bitcast<f32>(_e1824);
let _e1826 = local_4.member[2u];
let _e1827 = (_e1815 + _e1826);
let _e1829 = select(_e1381, _e1827, (_e1827 < _e1381));
let _e1834 = global_7.member[bitcast<u32>(select(0i, _e1829, (_e1829 > 0i)))];
let _e1836 = local_5[0u];
let _e1841 = local_5[1u];
let _e1844 = (_e1476 + ((_e1529 - _e1476) * _e1841));
let _e1845 = local_5[1u];
let _e1848 = (_e1582 + ((_e1635 - _e1582) * _e1845));
let _e1849 = local_5[1u];
let _e1852 = (_e1472 + (((_e1491 + ((_e1501 - _e1491) * _e1522)) - _e1472) * _e1849));
let _e1853 = local_5[1u];
let _e1858 = local_5[2u];
let _e1862 = local_5[1u];
let _e1865 = (_e1480 + (((_e1511 + ((bitcast<f32>(_e1520) - _e1511) * _e1530)) - _e1480) * _e1862));
let _e1866 = local_5[1u];
let _e1870 = local_5[2u];
let _e1874 = local_5[1u];
let _e1877 = (_e1664 + ((_e1476 - _e1664) * _e1874));
let _e1878 = local_5[1u];
let _e1882 = local_5[2u];
let _e1886 = local_5[1u];
let _e1889 = (_e1529 + (((_e1675 + ((bitcast<f32>(_e1684) - _e1675) * _e1686)) - _e1529) * _e1886));
let _e1890 = local_5[1u];
let _e1894 = local_5[2u];
let _e1898 = local_5[1u];
let _e1901 = (_e1764 + (((_e1800 + ((bitcast<f32>(_e1809) - _e1800) * _e1811)) - _e1764) * _e1898));
let _e1902 = local_5[2u];
let _e1906 = local_5[1u];
let _e1910 = local_5[2u];
let _e1914 = local_5[2u];
let _e1921 = global_1.member.member_7.member_5;
let _e1926 = global_1.member.member_7.member_6;
let _e1927 = (((_e1844 + ((_e1848 - _e1844) * _e1914)) * _e1921) + _e1926);
let _e1929 = select(0f, _e1927, (_e1927 > 0f));
let _e1933 = (((_e1852 + (((_e1578 + (((_e1597 + ((_e1607 - _e1597) * _e1628)) - _e1578) * _e1853)) - _e1852) * _e1858)) * _e1921) + _e1926);
let _e1935 = select(0f, _e1933, (_e1933 > 0f));
let _e1937 = select(1f, _e1935, (_e1935 < 1f));
let _e1939 = (((_e1865 + (((_e1586 + (((_e1617 + ((bitcast<f32>(_e1626) - _e1617) * _e1636)) - _e1586) * _e1866)) - _e1865) * _e1870)) * _e1921) + _e1926);
let _e1941 = select(0f, _e1939, (_e1939 > 0f));
let _e1943 = select(1f, _e1941, (_e1941 < 1f));
let _e1945 = (((_e1877 + (((_e1714 + ((_e1582 - _e1714) * _e1878)) - _e1877) * _e1882)) * _e1921) + _e1926);
let _e1947 = select(0f, _e1945, (_e1945 > 0f));
let _e1949 = select(1f, _e1947, (_e1947 < 1f));
let _e1951 = (((_e1889 + (((_e1635 + (((_e1725 + ((bitcast<f32>(_e1734) - _e1725) * _e1736)) - _e1635) * _e1890)) - _e1889) * _e1894)) * _e1921) + _e1926);
let _e1953 = select(0f, _e1951, (_e1951 > 0f));
let _e1955 = select(1f, _e1953, (_e1953 < 1f));
let _e1957 = (((_e1901 + ((_e1844 - _e1901) * _e1902)) * _e1921) + _e1926);
let _e1959 = select(0f, _e1957, (_e1957 > 0f));
let _e1961 = select(1f, _e1959, (_e1959 < 1f));
let _e1963 = (((_e1848 + (((_e1789 + (((_e1825 + ((bitcast<f32>(_e1834) - _e1825) * _e1836)) - _e1789) * _e1906)) - _e1848) * _e1910)) * _e1921) + _e1926);
let _e1965 = select(0f, _e1963, (_e1963 > 0f));
let _e1967 = select(1f, _e1965, (_e1965 < 1f));
let _e1968 = (select(1f, _e1929, (_e1929 < 1f)) * 1024f);
let _e1969 = (1024f - 1f);
let _e1971 = select(0f, _e1968, (_e1968 > 0f));
let _e1973 = select(_e1969, _e1971, (_e1971 < _e1969));
let _e1980 = select(0i, select(select(i32(_e1973), i32(-2147483648), (_e1973 < -2147483600f)), 2147483647i, (_e1973 > 2147483500f)), (_e1973 == _e1973));
let _e1984 = (_e1980 - select(0i, 1i, (_e1973 < f32(_e1980))));
let _e1985 = (262147i + _e1984);
let _e1987 = (bitcast<i32>(_e97) - 1i);
let _e1989 = select(_e1987, _e1985, (_e1985 < _e1987));
let _e1995 = global_4.member[bitcast<u32>(select(0i, _e1989, (_e1989 > 0i)))];
let _e2005 = select(_e1987, 262146i, (262146i < _e1987));
let _e2011 = global_4.member[bitcast<u32>(select(0i, _e2005, (_e2005 > 0i)))];
let _e2012 = bitcast<f32>(_e2011);
let _e2013 = (f32((bitcast<i32>((_e1995 & 4095u)) - 2048i)) * _e2012);
let _e2015 = select(_e1987, 262144i, (262144i < _e1987));
let _e2021 = global_4.member[bitcast<u32>(select(0i, _e2015, (_e2015 > 0i)))];
let _e2022 = bitcast<f32>(_e2021);
let _e2024 = select(_e1987, 262145i, (262145i < _e1987));
let _e2030 = global_4.member[bitcast<u32>(select(0i, _e2024, (_e2024 > 0i)))];
let _e2031 = bitcast<f32>(_e2030);
let _e2037 = ((_e2022 + (f32(bitcast<i32>((_e1995 >> bitcast<u32>(12u)))) * _e2031)) + (_e2013 * (_e1968 - f32(_e1984))));
let _e2038 = (_e2013 * 1024f);
if _e992 {
let _e2045 = ((0.5f * (_e1943 - _e1937)) * _e2038);
let _e2046 = ((0.5f * (_e1955 - _e1949)) * _e2038);
let _e2047 = ((0.5f * (_e1967 - _e1961)) * _e2038);
phi_4625_ = type_28(_e2037, vec3<f32>(_e2045, _e2046, _e2047), vec3<f32>((_e2045 * _e2037), (_e2046 * _e2037), (_e2047 * _e2037)));
} else {
let _e2054 = (_e1937 * 1024f);
let _e2056 = select(0f, _e2054, (_e2054 > 0f));
let _e2058 = select(_e1969, _e2056, (_e2056 < _e1969));
let _e2065 = select(0i, select(select(i32(_e2058), i32(-2147483648), (_e2058 < -2147483600f)), 2147483647i, (_e2058 > 2147483500f)), (_e2058 == _e2058));
let _e2069 = (_e2065 - select(0i, 1i, (_e2058 < f32(_e2065))));
let _e2070 = (262147i + _e2069);
let _e2072 = select(_e1987, _e2070, (_e2070 < _e1987));
let _e2078 = global_4.member[bitcast<u32>(select(0i, _e2072, (_e2072 > 0i)))];
let _e2093 = ((_e2022 + (f32(bitcast<i32>((_e2078 >> bitcast<u32>(12u)))) * _e2031)) + ((f32((bitcast<i32>((_e2078 & 4095u)) - 2048i)) * _e2012) * (_e2054 - f32(_e2069))));
let _e2094 = (_e1943 * 1024f);
let _e2096 = select(0f, _e2094, (_e2094 > 0f));
let _e2098 = select(_e1969, _e2096, (_e2096 < _e1969));
let _e2105 = select(0i, select(select(i32(_e2098), i32(-2147483648), (_e2098 < -2147483600f)), 2147483647i, (_e2098 > 2147483500f)), (_e2098 == _e2098));
let _e2109 = (_e2105 - select(0i, 1i, (_e2098 < f32(_e2105))));
let _e2110 = (262147i + _e2109);
let _e2112 = select(_e1987, _e2110, (_e2110 < _e1987));
let _e2118 = global_4.member[bitcast<u32>(select(0i, _e2112, (_e2112 > 0i)))];
let _e2133 = ((_e2022 + (f32(bitcast<i32>((_e2118 >> bitcast<u32>(12u)))) * _e2031)) + ((f32((bitcast<i32>((_e2118 & 4095u)) - 2048i)) * _e2012) * (_e2094 - f32(_e2109))));
let _e2134 = (_e1949 * 1024f);
let _e2136 = select(0f, _e2134, (_e2134 > 0f));
let _e2138 = select(_e1969, _e2136, (_e2136 < _e1969));
let _e2145 = select(0i, select(select(i32(_e2138), i32(-2147483648), (_e2138 < -2147483600f)), 2147483647i, (_e2138 > 2147483500f)), (_e2138 == _e2138));
let _e2149 = (_e2145 - select(0i, 1i, (_e2138 < f32(_e2145))));
let _e2150 = (262147i + _e2149);
let _e2152 = select(_e1987, _e2150, (_e2150 < _e1987));
let _e2158 = global_4.member[bitcast<u32>(select(0i, _e2152, (_e2152 > 0i)))];
let _e2173 = ((_e2022 + (f32(bitcast<i32>((_e2158 >> bitcast<u32>(12u)))) * _e2031)) + ((f32((bitcast<i32>((_e2158 & 4095u)) - 2048i)) * _e2012) * (_e2134 - f32(_e2149))));
let _e2174 = (_e1955 * 1024f);
let _e2176 = select(0f, _e2174, (_e2174 > 0f));
let _e2178 = select(_e1969, _e2176, (_e2176 < _e1969));
let _e2185 = select(0i, select(select(i32(_e2178), i32(-2147483648), (_e2178 < -2147483600f)), 2147483647i, (_e2178 > 2147483500f)), (_e2178 == _e2178));
let _e2189 = (_e2185 - select(0i, 1i, (_e2178 < f32(_e2185))));
let _e2190 = (262147i + _e2189);
let _e2192 = select(_e1987, _e2190, (_e2190 < _e1987));
let _e2198 = global_4.member[bitcast<u32>(select(0i, _e2192, (_e2192 > 0i)))];
let _e2213 = ((_e2022 + (f32(bitcast<i32>((_e2198 >> bitcast<u32>(12u)))) * _e2031)) + ((f32((bitcast<i32>((_e2198 & 4095u)) - 2048i)) * _e2012) * (_e2174 - f32(_e2189))));
let _e2214 = (_e1961 * 1024f);
let _e2216 = select(0f, _e2214, (_e2214 > 0f));
let _e2218 = select(_e1969, _e2216, (_e2216 < _e1969));
let _e2225 = select(0i, select(select(i32(_e2218), i32(-2147483648), (_e2218 < -2147483600f)), 2147483647i, (_e2218 > 2147483500f)), (_e2218 == _e2218));
let _e2229 = (_e2225 - select(0i, 1i, (_e2218 < f32(_e2225))));
let _e2230 = (262147i + _e2229);
let _e2232 = select(_e1987, _e2230, (_e2230 < _e1987));
let _e2238 = global_4.member[bitcast<u32>(select(0i, _e2232, (_e2232 > 0i)))];
let _e2253 = ((_e2022 + (f32(bitcast<i32>((_e2238 >> bitcast<u32>(12u)))) * _e2031)) + ((f32((bitcast<i32>((_e2238 & 4095u)) - 2048i)) * _e2012) * (_e2214 - f32(_e2229))));
let _e2254 = (_e1967 * 1024f);
let _e2256 = select(0f, _e2254, (_e2254 > 0f));
let _e2258 = select(_e1969, _e2256, (_e2256 < _e1969));
let _e2265 = select(0i, select(select(i32(_e2258), i32(-2147483648), (_e2258 < -2147483600f)), 2147483647i, (_e2258 > 2147483500f)), (_e2258 == _e2258));
let _e2269 = (_e2265 - select(0i, 1i, (_e2258 < f32(_e2265))));
let _e2270 = (262147i + _e2269);
let _e2272 = select(_e1987, _e2270, (_e2270 < _e1987));
let _e2278 = global_4.member[bitcast<u32>(select(0i, _e2272, (_e2272 > 0i)))];
let _e2293 = ((_e2022 + (f32(bitcast<i32>((_e2278 >> bitcast<u32>(12u)))) * _e2031)) + ((f32((bitcast<i32>((_e2278 & 4095u)) - 2048i)) * _e2012) * (_e2254 - f32(_e2269))));
let _e2294 = (_e2133 - _e2093);
let _e2296 = (_e2213 - _e2173);
let _e2298 = (_e2293 - _e2253);
phi_4625_ = type_28(_e2037, vec3<f32>((0.5f * _e2294), (0.5f * _e2296), (0.5f * _e2298)), vec3<f32>((0.25f * (_e2294 * (_e2133 + _e2093))), (0.25f * (_e2296 * (_e2213 + _e2173))), (0.25f * (_e2298 * (_e2293 + _e2253)))));
}
let _e2313 = phi_4625_;
let _e2328 = select(0f, 1f, ((((((_e960 >= -0.5f) && (_e960 <= _e1277)) && (_e975 >= -0.5f)) && (_e975 <= _e1287)) && (_e990 >= -0.5f)) && (_e990 <= _e1297)));
let _e2330 = (0.5f * (_e1943 - _e1937));
let _e2332 = (0.5f * (_e1955 - _e1949));
let _e2334 = (0.5f * (_e1967 - _e1961));
let _e2340 = global_1.member.member_7.member.member.member;
let _e2346 = global_1.member.member_7.member.member.member_1;
let _e2352 = global_1.member.member_7.member.member.member_2;
let _e2358 = global_1.member.member_7.member_1.member.member;
let _e2364 = global_1.member.member_7.member_1.member.member_1;
let _e2370 = global_1.member.member_7.member_1.member.member_2;
let _e2376 = global_1.member.member_7.member_2.member.member;
let _e2382 = global_1.member.member_7.member_2.member.member_1;
let _e2388 = global_1.member.member_7.member_2.member.member_2;
phi_5234_ = type_29(select(1f, _e1269, (_e1269 < 1f)), vec3<f32>(((((_e2340 * _e2330) + (_e2358 * _e2332)) + (_e2376 * _e2334)) * _e2328), ((((_e2346 * _e2330) + (_e2364 * _e2332)) + (_e2382 * _e2334)) * _e2328), ((((_e2352 * _e2330) + (_e2370 * _e2332)) + (_e2388 * _e2334)) * _e2328)), _e2313.member, vec3<f32>(((((_e2340 * _e2313.member_2.x) + (_e2358 * _e2313.member_2.y)) + (_e2376 * _e2313.member_2.z)) * _e2328), ((((_e2346 * _e2313.member_2.x) + (_e2364 * _e2313.member_2.y)) + (_e2382 * _e2313.member_2.z)) * _e2328), ((((_e2352 * _e2313.member_2.x) + (_e2370 * _e2313.member_2.y)) + (_e2388 * _e2313.member_2.z)) * _e2328)), vec3<f32>(((((_e2340 * _e2313.member_1.x) + (_e2358 * _e2313.member_1.y)) + (_e2376 * _e2313.member_1.z)) * _e2328), ((((_e2346 * _e2313.member_1.x) + (_e2364 * _e2313.member_1.y)) + (_e2382 * _e2313.member_1.z)) * _e2328), ((((_e2352 * _e2313.member_1.x) + (_e2370 * _e2313.member_1.y)) + (_e2388 * _e2313.member_1.z)) * _e2328)));
} else {
let _e2457 = global_1.member.member_6.member_3.member;
let _e2458 = (_e2457 - 0.5f);
let _e2460 = select(-0.5f, _e933, (_e933 > -0.5f));
let _e2462 = select(_e2458, _e2460, (_e2460 < _e2458));
let _e2467 = global_1.member.member_6.member_3.member_1;
let _e2468 = (_e2467 - 0.5f);
let _e2470 = select(-0.5f, _e939, (_e939 > -0.5f));
let _e2472 = select(_e2468, _e2470, (_e2470 < _e2468));
let _e2477 = global_1.member.member_6.member_3.member_2;
let _e2478 = (_e2477 - 0.5f);
let _e2480 = select(-0.5f, _e945, (_e945 > -0.5f));
let _e2482 = select(_e2478, _e2480, (_e2480 < _e2478));
let _e2484 = select(-1f, _e2462, (_e2462 > -1f));
let _e2486 = select(_e2457, _e2484, (_e2484 < _e2457));
let _e2493 = select(0i, select(select(i32(_e2486), i32(-2147483648), (_e2486 < -2147483600f)), 2147483647i, (_e2486 > 2147483500f)), (_e2486 == _e2486));
let _e2497 = (_e2493 - select(0i, 1i, (_e2486 < f32(_e2493))));
let _e2499 = select(-1f, _e2472, (_e2472 > -1f));
let _e2501 = select(_e2467, _e2499, (_e2499 < _e2467));
let _e2508 = select(0i, select(select(i32(_e2501), i32(-2147483648), (_e2501 < -2147483600f)), 2147483647i, (_e2501 > 2147483500f)), (_e2501 == _e2501));
let _e2512 = (_e2508 - select(0i, 1i, (_e2501 < f32(_e2508))));
let _e2514 = select(-1f, _e2482, (_e2482 > -1f));
let _e2516 = select(_e2477, _e2514, (_e2514 < _e2477));
let _e2523 = select(0i, select(select(i32(_e2516), i32(-2147483648), (_e2516 < -2147483600f)), 2147483647i, (_e2516 > 2147483500f)), (_e2516 == _e2516));
let _e2527 = (_e2523 - select(0i, 1i, (_e2516 < f32(_e2523))));
let _e2531 = global_1.member.member_6.member_7;
let _e2535 = global_1.member.member_6.member_8;
let _e2536 = (_e2497 + 1i);
let _e2537 = (_e2512 + 1i);
let _e2538 = (_e2527 + 1i);
let _e2543 = global_1.member.member_6.member_11.member;
let _e2549 = global_1.member.member_6.member_11.member_1;
let _e2560 = ((_e2536 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2543) * ((_e2537 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2549) * (_e2538 >> bitcast<u32>(4i))))));
let _e2562 = (bitcast<i32>(_e90) - 1i);
let _e2564 = select(_e2562, _e2560, (_e2560 < _e2562));
let _e2570 = global_2.member[bitcast<u32>(select(0i, _e2564, (_e2564 > 0i)))];
let _e2572 = (_e2536 & 15i);
let _e2575 = ((_e2537 & 15i) * _e2531);
let _e2577 = (bitcast<i32>(_e2570) + ((_e2538 & 15i) * _e2535));
let _e2581 = (_e2575 + _e2531);
let _e2583 = (_e2575 + (2i * _e2531));
let _e2584 = (_e2577 + _e2535);
let _e2586 = (_e2577 + (2i * _e2535));
local_2 = type_27(array<i32, 4>(_e2572, (_e2572 + 1i), (_e2572 + 2i), (_e2572 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e2462 - f32(_e2497)), (_e2472 - f32(_e2512)), (_e2482 - f32(_e2527)));
let _e2597 = (_e2584 + _e2581);
let _e2600 = local_2.member[1u];
let _e2601 = (_e2597 + _e2600);
let _e2603 = select(_e2562, _e2601, (_e2601 < _e2562));
let _e2608 = global_2.member[bitcast<u32>(select(0i, _e2603, (_e2603 > 0i)))];
let _e2609 = bitcast<f32>(_e2608);
let _e2612 = local_2.member[2u];
let _e2613 = (_e2597 + _e2612);
let _e2615 = select(_e2562, _e2613, (_e2613 < _e2562));
let _e2620 = global_2.member[bitcast<u32>(select(0i, _e2615, (_e2615 > 0i)))];
let _e2622 = local_3[0u];
let _e2625 = (_e2609 + ((bitcast<f32>(_e2620) - _e2609) * _e2622));
let _e2626 = (_e2584 + _e2583);
let _e2627 = local_2.member[1u];
let _e2628 = (_e2626 + _e2627);
let _e2630 = select(_e2562, _e2628, (_e2628 < _e2562));
let _e2635 = global_2.member[bitcast<u32>(select(0i, _e2630, (_e2630 > 0i)))];
let _e2636 = bitcast<f32>(_e2635);
let _e2637 = local_2.member[2u];
let _e2638 = (_e2626 + _e2637);
let _e2640 = select(_e2562, _e2638, (_e2638 < _e2562));
let _e2645 = global_2.member[bitcast<u32>(select(0i, _e2640, (_e2640 > 0i)))];
let _e2647 = local_3[0u];
let _e2652 = local_3[1u];
let _e2655 = (_e2625 + (((_e2636 + ((bitcast<f32>(_e2645) - _e2636) * _e2647)) - _e2625) * _e2652));
let _e2656 = (_e2586 + _e2581);
let _e2657 = local_2.member[1u];
let _e2658 = (_e2656 + _e2657);
let _e2660 = select(_e2562, _e2658, (_e2658 < _e2562));
let _e2665 = global_2.member[bitcast<u32>(select(0i, _e2660, (_e2660 > 0i)))];
let _e2666 = bitcast<f32>(_e2665);
let _e2667 = local_2.member[2u];
let _e2668 = (_e2656 + _e2667);
let _e2670 = select(_e2562, _e2668, (_e2668 < _e2562));
let _e2675 = global_2.member[bitcast<u32>(select(0i, _e2670, (_e2670 > 0i)))];
let _e2677 = local_3[0u];
let _e2680 = (_e2666 + ((bitcast<f32>(_e2675) - _e2666) * _e2677));
let _e2681 = (_e2586 + _e2583);
let _e2682 = local_2.member[1u];
let _e2683 = (_e2681 + _e2682);
let _e2685 = select(_e2562, _e2683, (_e2683 < _e2562));
let _e2690 = global_2.member[bitcast<u32>(select(0i, _e2685, (_e2685 > 0i)))];
let _e2691 = bitcast<f32>(_e2690);
let _e2692 = local_2.member[2u];
let _e2693 = (_e2681 + _e2692);
let _e2695 = select(_e2562, _e2693, (_e2693 < _e2562));
let _e2700 = global_2.member[bitcast<u32>(select(0i, _e2695, (_e2695 > 0i)))];
let _e2702 = local_3[0u];
let _e2706 = local_3[1u];
let _e2711 = local_3[2u];
let _e2718 = global_1.member.member_6.member_5;
let _e2723 = global_1.member.member_6.member_6;
let _e2724 = (((_e2655 + (((_e2680 + (((_e2691 + ((bitcast<f32>(_e2700) - _e2691) * _e2702)) - _e2680) * _e2706)) - _e2655) * _e2711)) * _e2718) + _e2723);
let _e2726 = select(0f, _e2724, (_e2724 > 0f));
phi_5234_ = type_29(select(1f, _e2726, (_e2726 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2731 = phi_5234_;
let _e2736 = global_1.member.member_6.member_3.member;
let _e2737 = (_e2736 - 0.5f);
let _e2739 = select(-0.5f, _e897, (_e897 > -0.5f));
let _e2741 = select(_e2737, _e2739, (_e2739 < _e2737));
let _e2746 = global_1.member.member_6.member_3.member_1;
let _e2747 = (_e2746 - 0.5f);
let _e2749 = select(-0.5f, _e912, (_e912 > -0.5f));
let _e2751 = select(_e2747, _e2749, (_e2749 < _e2747));
let _e2756 = global_1.member.member_6.member_3.member_2;
let _e2757 = (_e2756 - 0.5f);
let _e2759 = select(-0.5f, _e927, (_e927 > -0.5f));
let _e2761 = select(_e2757, _e2759, (_e2759 < _e2757));
let _e2763 = select(-1f, _e2741, (_e2741 > -1f));
let _e2765 = select(_e2736, _e2763, (_e2763 < _e2736));
let _e2772 = select(0i, select(select(i32(_e2765), i32(-2147483648), (_e2765 < -2147483600f)), 2147483647i, (_e2765 > 2147483500f)), (_e2765 == _e2765));
let _e2776 = (_e2772 - select(0i, 1i, (_e2765 < f32(_e2772))));
let _e2778 = select(-1f, _e2751, (_e2751 > -1f));
let _e2780 = select(_e2746, _e2778, (_e2778 < _e2746));
let _e2787 = select(0i, select(select(i32(_e2780), i32(-2147483648), (_e2780 < -2147483600f)), 2147483647i, (_e2780 > 2147483500f)), (_e2780 == _e2780));
let _e2791 = (_e2787 - select(0i, 1i, (_e2780 < f32(_e2787))));
let _e2793 = select(-1f, _e2761, (_e2761 > -1f));
let _e2795 = select(_e2756, _e2793, (_e2793 < _e2756));
let _e2802 = select(0i, select(select(i32(_e2795), i32(-2147483648), (_e2795 < -2147483600f)), 2147483647i, (_e2795 > 2147483500f)), (_e2795 == _e2795));
let _e2806 = (_e2802 - select(0i, 1i, (_e2795 < f32(_e2802))));
let _e2810 = global_1.member.member_6.member_7;
let _e2814 = global_1.member.member_6.member_8;
let _e2815 = (_e2776 + 1i);
let _e2816 = (_e2791 + 1i);
let _e2817 = (_e2806 + 1i);
let _e2822 = global_1.member.member_6.member_11.member;
let _e2828 = global_1.member.member_6.member_11.member_1;
let _e2839 = ((_e2815 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2822) * ((_e2816 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2828) * (_e2817 >> bitcast<u32>(4i))))));
let _e2841 = (bitcast<i32>(_e90) - 1i);
let _e2843 = select(_e2841, _e2839, (_e2839 < _e2841));
let _e2849 = global_2.member[bitcast<u32>(select(0i, _e2843, (_e2843 > 0i)))];
let _e2851 = (_e2815 & 15i);
let _e2854 = ((_e2816 & 15i) * _e2810);
let _e2856 = (bitcast<i32>(_e2849) + ((_e2817 & 15i) * _e2814));
let _e2860 = (_e2854 + _e2810);
let _e2862 = (_e2854 + (2i * _e2810));
let _e2863 = (_e2856 + _e2814);
let _e2865 = (_e2856 + (2i * _e2814));
local = type_27(array<i32, 4>(_e2851, (_e2851 + 1i), (_e2851 + 2i), (_e2851 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_1 = vec3<f32>((_e2741 - f32(_e2776)), (_e2751 - f32(_e2791)), (_e2761 - f32(_e2806)));
let _e2876 = (_e2863 + _e2860);
let _e2879 = local.member[1u];
let _e2880 = (_e2876 + _e2879);
let _e2882 = select(_e2841, _e2880, (_e2880 < _e2841));
let _e2887 = global_2.member[bitcast<u32>(select(0i, _e2882, (_e2882 > 0i)))];
let _e2888 = bitcast<f32>(_e2887);
let _e2891 = local.member[2u];
let _e2892 = (_e2876 + _e2891);
let _e2894 = select(_e2841, _e2892, (_e2892 < _e2841));
let _e2899 = global_2.member[bitcast<u32>(select(0i, _e2894, (_e2894 > 0i)))];
let _e2901 = local_1[0u];
let _e2904 = (_e2888 + ((bitcast<f32>(_e2899) - _e2888) * _e2901));
let _e2905 = (_e2863 + _e2862);
let _e2906 = local.member[1u];
let _e2907 = (_e2905 + _e2906);
let _e2909 = select(_e2841, _e2907, (_e2907 < _e2841));
let _e2914 = global_2.member[bitcast<u32>(select(0i, _e2909, (_e2909 > 0i)))];
let _e2915 = bitcast<f32>(_e2914);
let _e2916 = local.member[2u];
let _e2917 = (_e2905 + _e2916);
let _e2919 = select(_e2841, _e2917, (_e2917 < _e2841));
let _e2924 = global_2.member[bitcast<u32>(select(0i, _e2919, (_e2919 > 0i)))];
let _e2926 = local_1[0u];
let _e2931 = local_1[1u];
let _e2934 = (_e2904 + (((_e2915 + ((bitcast<f32>(_e2924) - _e2915) * _e2926)) - _e2904) * _e2931));
let _e2935 = (_e2865 + _e2860);
let _e2936 = local.member[1u];
let _e2937 = (_e2935 + _e2936);
let _e2939 = select(_e2841, _e2937, (_e2937 < _e2841));
let _e2944 = global_2.member[bitcast<u32>(select(0i, _e2939, (_e2939 > 0i)))];
let _e2945 = bitcast<f32>(_e2944);
let _e2946 = local.member[2u];
let _e2947 = (_e2935 + _e2946);
let _e2949 = select(_e2841, _e2947, (_e2947 < _e2841));
let _e2954 = global_2.member[bitcast<u32>(select(0i, _e2949, (_e2949 > 0i)))];
let _e2956 = local_1[0u];
let _e2959 = (_e2945 + ((bitcast<f32>(_e2954) - _e2945) * _e2956));
let _e2960 = (_e2865 + _e2862);
let _e2961 = local.member[1u];
let _e2962 = (_e2960 + _e2961);
let _e2964 = select(_e2841, _e2962, (_e2962 < _e2841));
let _e2969 = global_2.member[bitcast<u32>(select(0i, _e2964, (_e2964 > 0i)))];
let _e2970 = bitcast<f32>(_e2969);
let _e2971 = local.member[2u];
let _e2972 = (_e2960 + _e2971);
let _e2974 = select(_e2841, _e2972, (_e2972 < _e2841));
let _e2979 = global_2.member[bitcast<u32>(select(0i, _e2974, (_e2974 > 0i)))];
let _e2981 = local_1[0u];
let _e2985 = local_1[1u];
let _e2990 = local_1[2u];
let _e2997 = global_1.member.member_6.member_5;
let _e3002 = global_1.member.member_6.member_6;
let _e3003 = (((_e2934 + (((_e2959 + (((_e2970 + ((bitcast<f32>(_e2979) - _e2970) * _e2981)) - _e2959) * _e2985)) - _e2934) * _e2990)) * _e2997) + _e3002);
let _e3005 = select(0f, _e3003, (_e3003 > 0f));
let _e3007 = select(1f, _e3005, (_e3005 < 1f));
let _e3010 = global_1.member.member_1;
if ((_e3010 & 16u) == 0u) {
phi_6030_ = type_5(1f, 1f, 1f);
} else {
let _e3016 = global_1.member.member_14.member;
let _e3027 = ((((_e3016.member.member * _e854) + (_e3016.member.member_1 * _e867)) + (_e3016.member.member_2 * _e832)) + _e3016.member_1);
let _e3033 = ((((_e3016.member.member * _e877) + (_e3016.member.member_1 * _e882)) + (_e3016.member.member_2 * _e871)) + _e3016.member_1);
let _e3035 = select(_e3033, _e3027, (_e3027 < _e3033));
let _e3037 = select(_e3033, _e3027, (_e3027 > _e3033));
let _e3039 = (_e3037 - _e3035);
let _e3042 = (-(_e3035) / select(1e-30f, _e3039, (_e3039 > 1e-30f)));
let _e3044 = select(0f, _e3042, (_e3042 > 0f));
let _e3050 = select(select(select(1f, _e3044, (_e3044 < 1f)), 1f, (_e3037 <= 0f)), 0f, (_e3035 > 0f));
let _e3055 = global_1.member.member_14.member_1;
let _e3056 = (_e3055 != 0u);
let _e3066 = global_1.member.member_15.member;
let _e3077 = ((((_e3066.member.member * _e854) + (_e3066.member.member_1 * _e867)) + (_e3066.member.member_2 * _e832)) + _e3066.member_1);
let _e3083 = ((((_e3066.member.member * _e877) + (_e3066.member.member_1 * _e882)) + (_e3066.member.member_2 * _e871)) + _e3066.member_1);
let _e3085 = select(_e3083, _e3077, (_e3077 < _e3083));
let _e3087 = select(_e3083, _e3077, (_e3077 > _e3083));
let _e3089 = (_e3087 - _e3085);
let _e3092 = (-(_e3085) / select(1e-30f, _e3089, (_e3089 > 1e-30f)));
let _e3094 = select(0f, _e3092, (_e3092 > 0f));
let _e3100 = select(select(select(1f, _e3094, (_e3094 < 1f)), 1f, (_e3087 <= 0f)), 0f, (_e3085 > 0f));
let _e3105 = global_1.member.member_15.member_1;
let _e3106 = (_e3105 != 0u);
let _e3116 = global_1.member.member_16.member;
let _e3127 = ((((_e3116.member.member * _e854) + (_e3116.member.member_1 * _e867)) + (_e3116.member.member_2 * _e832)) + _e3116.member_1);
let _e3133 = ((((_e3116.member.member * _e877) + (_e3116.member.member_1 * _e882)) + (_e3116.member.member_2 * _e871)) + _e3116.member_1);
let _e3135 = select(_e3133, _e3127, (_e3127 < _e3133));
let _e3137 = select(_e3133, _e3127, (_e3127 > _e3133));
let _e3139 = (_e3137 - _e3135);
let _e3142 = (-(_e3135) / select(1e-30f, _e3139, (_e3139 > 1e-30f)));
let _e3144 = select(0f, _e3142, (_e3142 > 0f));
let _e3150 = select(select(select(1f, _e3144, (_e3144 < 1f)), 1f, (_e3137 <= 0f)), 0f, (_e3135 > 0f));
let _e3155 = global_1.member.member_16.member_1;
let _e3156 = (_e3155 != 0u);
let _e3166 = global_1.member.member_17.member;
let _e3177 = ((((_e3166.member.member * _e854) + (_e3166.member.member_1 * _e867)) + (_e3166.member.member_2 * _e832)) + _e3166.member_1);
let _e3183 = ((((_e3166.member.member * _e877) + (_e3166.member.member_1 * _e882)) + (_e3166.member.member_2 * _e871)) + _e3166.member_1);
let _e3185 = select(_e3183, _e3177, (_e3177 < _e3183));
let _e3187 = select(_e3183, _e3177, (_e3177 > _e3183));
let _e3189 = (_e3187 - _e3185);
let _e3192 = (-(_e3185) / select(1e-30f, _e3189, (_e3189 > 1e-30f)));
let _e3194 = select(0f, _e3192, (_e3192 > 0f));
let _e3200 = select(select(select(1f, _e3194, (_e3194 < 1f)), 1f, (_e3187 <= 0f)), 0f, (_e3185 > 0f));
let _e3205 = global_1.member.member_17.member_1;
let _e3206 = (_e3205 != 0u);
phi_6030_ = type_5(((((1f * _e3050) * _e3100) * _e3150) * _e3200), ((((1f * select(1f, _e3050, _e3056)) * select(1f, _e3100, _e3106)) * select(1f, _e3150, _e3156)) * select(1f, _e3200, _e3206)), ((((1f * select(1f, 0f, (_e3056 && (_e3033 > 0f)))) * select(1f, 0f, (_e3106 && (_e3083 > 0f)))) * select(1f, 0f, (_e3156 && (_e3133 > 0f)))) * select(1f, 0f, (_e3206 && (_e3183 > 0f)))));
}
let _e3215 = phi_6030_;
let _e3216 = (_e933 - _e897);
let _e3220 = (bitcast<f32>((bitcast<u32>(_e3216) & 2147483647u)) < 1e-12f);
let _e3222 = (1f / select(_e3216, 1f, _e3220));
let _e3224 = ((-0.5f - _e897) * _e3222);
let _e3226 = ((_e2737 - _e897) * _e3222);
let _e3232 = select(_e3226, _e3224, (_e3224 < _e3226));
let _e3234 = select(0f, _e3232, (_e3232 > 0f));
let _e3237 = select(select(1f, _e3234, (_e3234 < 1f)), select(2f, 0f, ((_e897 >= -0.5f) && (_e897 <= _e2737))), _e3220);
let _e3239 = select(_e3226, _e3224, (_e3224 > _e3226));
let _e3241 = select(0f, _e3239, (_e3239 > 0f));
let _e3244 = select(select(1f, _e3241, (_e3241 < 1f)), 1f, _e3220);
let _e3245 = (_e939 - _e912);
let _e3249 = (bitcast<f32>((bitcast<u32>(_e3245) & 2147483647u)) < 1e-12f);
let _e3251 = (1f / select(_e3245, 1f, _e3249));
let _e3253 = ((-0.5f - _e912) * _e3251);
let _e3255 = ((_e2747 - _e912) * _e3251);
let _e3261 = select(_e3255, _e3253, (_e3253 < _e3255));
let _e3263 = select(0f, _e3261, (_e3261 > 0f));
let _e3266 = select(select(1f, _e3263, (_e3263 < 1f)), select(2f, 0f, ((_e912 >= -0.5f) && (_e912 <= _e2747))), _e3249);
let _e3268 = select(_e3255, _e3253, (_e3253 > _e3255));
let _e3270 = select(0f, _e3268, (_e3268 > 0f));
let _e3273 = select(select(1f, _e3270, (_e3270 < 1f)), 1f, _e3249);
let _e3274 = (_e945 - _e927);
let _e3278 = (bitcast<f32>((bitcast<u32>(_e3274) & 2147483647u)) < 1e-12f);
let _e3280 = (1f / select(_e3274, 1f, _e3278));
let _e3282 = ((-0.5f - _e927) * _e3280);
let _e3284 = ((_e2757 - _e927) * _e3280);
let _e3290 = select(_e3284, _e3282, (_e3282 < _e3284));
let _e3292 = select(0f, _e3290, (_e3290 > 0f));
let _e3295 = select(select(1f, _e3292, (_e3292 < 1f)), select(2f, 0f, ((_e927 >= -0.5f) && (_e927 <= _e2757))), _e3278);
let _e3297 = select(_e3284, _e3282, (_e3282 > _e3284));
let _e3299 = select(0f, _e3297, (_e3297 > 0f));
let _e3302 = select(select(1f, _e3299, (_e3299 < 1f)), 1f, _e3278);
let _e3304 = select(_e3273, _e3244, (_e3244 < _e3273));
let _e3308 = select(_e3266, _e3237, (_e3237 > _e3266));
let _e3311 = (select(_e3302, _e3304, (_e3304 < _e3302)) - select(_e3295, _e3308, (_e3308 > _e3295)));
let _e3314 = (_e877 - _e854);
let _e3315 = (_e882 - _e867);
let _e3316 = (_e871 - _e832);
let _e3321 = (((_e3314 * _e3314) + (_e3315 * _e3315)) + (_e3316 * _e3316));
let _e3329 = global_1.member.member_5.member_3;
let _e3330 = ((sqrt(select(0f, _e3321, (_e3321 > 0f))) * select(0f, _e3311, (_e3311 > 0f))) * _e3329);
if (_e107.member_2 >= 3u) {
let _e3333 = (_e3007 * 255f);
let _e3334 = (_e2731.member * 255f);
let _e3335 = (255f - 1f);
let _e3337 = select(0f, _e3333, (_e3333 > 0f));
let _e3339 = select(_e3335, _e3337, (_e3337 < _e3335));
let _e3346 = select(0i, select(select(i32(_e3339), i32(-2147483648), (_e3339 < -2147483600f)), 2147483647i, (_e3339 > 2147483500f)), (_e3339 == _e3339));
let _e3350 = (_e3346 - select(0i, 1i, (_e3339 < f32(_e3346))));
let _e3352 = select(0f, _e3334, (_e3334 > 0f));
let _e3354 = select(_e3335, _e3352, (_e3352 < _e3335));
let _e3361 = select(0i, select(select(i32(_e3354), i32(-2147483648), (_e3354 < -2147483600f)), 2147483647i, (_e3354 > 2147483500f)), (_e3354 == _e3354));
let _e3365 = (_e3361 - select(0i, 1i, (_e3354 < f32(_e3361))));
let _e3368 = (((_e3350 * 256i) + _e3365) * 4i);
let _e3372 = (_e3334 - f32(_e3365));
let _e3374 = (bitcast<i32>(_e97) - 1i);
let _e3376 = select(_e3374, _e3368, (_e3368 < _e3374));
let _e3382 = global_4.member[bitcast<u32>(select(0i, _e3376, (_e3376 > 0i)))];
let _e3383 = (_e3368 + 4i);
let _e3385 = select(_e3374, _e3383, (_e3383 < _e3374));
let _e3391 = global_4.member[bitcast<u32>(select(0i, _e3385, (_e3385 > 0i)))];
let _e3392 = (_e3368 + 1024i);
let _e3394 = select(_e3374, _e3392, (_e3392 < _e3374));
let _e3400 = global_4.member[bitcast<u32>(select(0i, _e3394, (_e3394 > 0i)))];
let _e3401 = (_e3368 + 1028i);
let _e3403 = select(_e3374, _e3401, (_e3401 < _e3374));
let _e3409 = global_4.member[bitcast<u32>(select(0i, _e3403, (_e3403 > 0i)))];
let _e3414 = (bitcast<f32>(((_e3382 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3422 = (_e3414 + (((bitcast<f32>(((_e3391 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3414) * _e3372));
let _e3427 = (bitcast<f32>(((_e3400 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3438 = (_e3422 + (((_e3427 + (((bitcast<f32>(((_e3409 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3427) * _e3372)) - _e3422) * (_e3333 - f32(_e3350))));
let _e3442 = -((_e3438 * (_e3330 * _e3215.member)));
let _e3444 = select(-87f, _e3442, (_e3442 > -87f));
let _e3446 = select(88f, _e3444, (_e3444 < 88f));
let _e3448 = ((_e3446 * 1.442695f) + 0.5f);
let _e3450 = select(-127f, _e3448, (_e3448 > -127f));
let _e3452 = select(128f, _e3450, (_e3450 < 128f));
let _e3459 = select(0i, select(select(i32(_e3452), i32(-2147483648), (_e3452 < -2147483600f)), 2147483647i, (_e3452 > 2147483500f)), (_e3452 == _e3452));
let _e3463 = (_e3459 - select(0i, 1i, (_e3452 < f32(_e3459))));
let _e3464 = f32(_e3463);
let _e3468 = ((_e3446 - (_e3464 * 0.6933594f)) - (_e3464 * -2.1219444e-4f));
let _e3488 = ((1f + (_e3468 * (1f + (_e3468 * (0.5f + (_e3468 * (0.16666667f + (_e3468 * (0.041666668f + (_e3468 * (0.008333334f + (_e3468 * (0.001388889f + (_e3468 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3463 + 127i)) << bitcast<u32>(23i))));
let _e3489 = (1f - _e3488);
phi_7140_ = type_30(_e3488, _e3489, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e3489 / select(1e-12f, _e3438, (_e3438 > 1e-12f))))));
} else {
let _e3497 = (_e3007 * 255f);
let _e3498 = (_e2731.member * 255f);
let _e3499 = (255f - 1f);
let _e3501 = select(0f, _e3497, (_e3497 > 0f));
let _e3503 = select(_e3499, _e3501, (_e3501 < _e3499));
let _e3510 = select(0i, select(select(i32(_e3503), i32(-2147483648), (_e3503 < -2147483600f)), 2147483647i, (_e3503 > 2147483500f)), (_e3503 == _e3503));
let _e3514 = (_e3510 - select(0i, 1i, (_e3503 < f32(_e3510))));
let _e3516 = select(0f, _e3498, (_e3498 > 0f));
let _e3518 = select(_e3499, _e3516, (_e3516 < _e3499));
let _e3525 = select(0i, select(select(i32(_e3518), i32(-2147483648), (_e3518 < -2147483600f)), 2147483647i, (_e3518 > 2147483500f)), (_e3518 == _e3518));
let _e3529 = (_e3525 - select(0i, 1i, (_e3518 < f32(_e3525))));
let _e3532 = (((_e3514 * 256i) + _e3529) * 4i);
let _e3534 = (_e3497 - f32(_e3514));
let _e3536 = (_e3498 - f32(_e3529));
let _e3538 = (bitcast<i32>(_e97) - 1i);
let _e3540 = select(_e3538, _e3532, (_e3532 < _e3538));
let _e3546 = global_4.member[bitcast<u32>(select(0i, _e3540, (_e3540 > 0i)))];
let _e3547 = (_e3532 + 4i);
let _e3549 = select(_e3538, _e3547, (_e3547 < _e3538));
let _e3555 = global_4.member[bitcast<u32>(select(0i, _e3549, (_e3549 > 0i)))];
let _e3556 = (_e3532 + 1024i);
let _e3558 = select(_e3538, _e3556, (_e3556 < _e3538));
let _e3564 = global_4.member[bitcast<u32>(select(0i, _e3558, (_e3558 > 0i)))];
let _e3565 = (_e3532 + 1028i);
let _e3567 = select(_e3538, _e3565, (_e3565 < _e3538));
let _e3573 = global_4.member[bitcast<u32>(select(0i, _e3567, (_e3567 > 0i)))];
let _e3578 = (bitcast<f32>(((_e3546 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3586 = (_e3578 + (((bitcast<f32>(((_e3555 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3578) * _e3536));
let _e3591 = (bitcast<f32>(((_e3564 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3602 = (_e3586 + (((_e3591 + (((bitcast<f32>(((_e3573 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3591) * _e3536)) - _e3586) * _e3534));
let _e3615 = (bitcast<f32>((((_e3546 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3623 = (_e3615 + (((bitcast<f32>((((_e3555 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3615) * _e3536));
let _e3628 = (bitcast<f32>((((_e3564 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3640 = (_e3532 + 1i);
let _e3642 = select(_e3538, _e3640, (_e3640 < _e3538));
let _e3648 = global_4.member[bitcast<u32>(select(0i, _e3642, (_e3642 > 0i)))];
let _e3649 = (_e3532 + 5i);
let _e3651 = select(_e3538, _e3649, (_e3649 < _e3538));
let _e3657 = global_4.member[bitcast<u32>(select(0i, _e3651, (_e3651 > 0i)))];
let _e3658 = (_e3532 + 1025i);
let _e3660 = select(_e3538, _e3658, (_e3658 < _e3538));
let _e3666 = global_4.member[bitcast<u32>(select(0i, _e3660, (_e3660 > 0i)))];
let _e3667 = (_e3532 + 1029i);
let _e3669 = select(_e3538, _e3667, (_e3667 < _e3538));
let _e3675 = global_4.member[bitcast<u32>(select(0i, _e3669, (_e3669 > 0i)))];
let _e3680 = (bitcast<f32>(((_e3648 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3688 = (_e3680 + (((bitcast<f32>(((_e3657 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3680) * _e3536));
let _e3693 = (bitcast<f32>(((_e3666 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3717 = (bitcast<f32>((((_e3648 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3725 = (_e3717 + (((bitcast<f32>((((_e3657 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3717) * _e3536));
let _e3730 = (bitcast<f32>((((_e3666 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3745 = (_e3330 * _e3215.member_1);
let _e3747 = -(((_e3623 + (((_e3628 + (((bitcast<f32>((((_e3573 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3628) * _e3536)) - _e3623) * _e3534)) * _e3745));
let _e3749 = select(-87f, _e3747, (_e3747 > -87f));
let _e3751 = select(88f, _e3749, (_e3749 < 88f));
let _e3753 = ((_e3751 * 1.442695f) + 0.5f);
let _e3755 = select(-127f, _e3753, (_e3753 > -127f));
let _e3757 = select(128f, _e3755, (_e3755 < 128f));
let _e3764 = select(0i, select(select(i32(_e3757), i32(-2147483648), (_e3757 < -2147483600f)), 2147483647i, (_e3757 > 2147483500f)), (_e3757 == _e3757));
let _e3768 = (_e3764 - select(0i, 1i, (_e3757 < f32(_e3764))));
let _e3769 = f32(_e3768);
let _e3773 = ((_e3751 - (_e3769 * 0.6933594f)) - (_e3769 * -2.1219444e-4f));
let _e3795 = -(((_e3688 + (((_e3693 + (((bitcast<f32>(((_e3675 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3693) * _e3536)) - _e3688) * _e3534)) * _e3745));
let _e3797 = select(-87f, _e3795, (_e3795 > -87f));
let _e3799 = select(88f, _e3797, (_e3797 < 88f));
let _e3801 = ((_e3799 * 1.442695f) + 0.5f);
let _e3803 = select(-127f, _e3801, (_e3801 > -127f));
let _e3805 = select(128f, _e3803, (_e3803 < 128f));
let _e3812 = select(0i, select(select(i32(_e3805), i32(-2147483648), (_e3805 < -2147483600f)), 2147483647i, (_e3805 > 2147483500f)), (_e3805 == _e3805));
let _e3816 = (_e3812 - select(0i, 1i, (_e3805 < f32(_e3812))));
let _e3817 = f32(_e3816);
let _e3821 = ((_e3799 - (_e3817 * 0.6933594f)) - (_e3817 * -2.1219444e-4f));
let _e3843 = -(((_e3725 + (((_e3730 + (((bitcast<f32>((((_e3675 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3730) * _e3536)) - _e3725) * _e3534)) * _e3745));
let _e3845 = select(-87f, _e3843, (_e3843 > -87f));
let _e3847 = select(88f, _e3845, (_e3845 < 88f));
let _e3849 = ((_e3847 * 1.442695f) + 0.5f);
let _e3851 = select(-127f, _e3849, (_e3849 > -127f));
let _e3853 = select(128f, _e3851, (_e3851 < 128f));
let _e3860 = select(0i, select(select(i32(_e3853), i32(-2147483648), (_e3853 < -2147483600f)), 2147483647i, (_e3853 > 2147483500f)), (_e3853 == _e3853));
let _e3864 = (_e3860 - select(0i, 1i, (_e3853 < f32(_e3860))));
let _e3865 = f32(_e3864);
let _e3869 = ((_e3847 - (_e3865 * 0.6933594f)) - (_e3865 * -2.1219444e-4f));
let _e3892 = -((_e3602 * (_e3330 * _e3215.member)));
let _e3894 = select(-87f, _e3892, (_e3892 > -87f));
let _e3896 = select(88f, _e3894, (_e3894 < 88f));
let _e3898 = ((_e3896 * 1.442695f) + 0.5f);
let _e3900 = select(-127f, _e3898, (_e3898 > -127f));
let _e3902 = select(128f, _e3900, (_e3900 < 128f));
let _e3909 = select(0i, select(select(i32(_e3902), i32(-2147483648), (_e3902 < -2147483600f)), 2147483647i, (_e3902 > 2147483500f)), (_e3902 == _e3902));
let _e3913 = (_e3909 - select(0i, 1i, (_e3902 < f32(_e3909))));
let _e3914 = f32(_e3913);
let _e3918 = ((_e3896 - (_e3914 * 0.6933594f)) - (_e3914 * -2.1219444e-4f));
let _e3938 = ((1f + (_e3918 * (1f + (_e3918 * (0.5f + (_e3918 * (0.16666667f + (_e3918 * (0.041666668f + (_e3918 * (0.008333334f + (_e3918 * (0.001388889f + (_e3918 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3913 + 127i)) << bitcast<u32>(23i))));
let _e3939 = (1f - _e3938);
phi_7140_ = type_30(_e3938, _e3939, vec3<f32>(((1f + (_e3773 * (1f + (_e3773 * (0.5f + (_e3773 * (0.16666667f + (_e3773 * (0.041666668f + (_e3773 * (0.008333334f + (_e3773 * (0.001388889f + (_e3773 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3768 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3821 * (1f + (_e3821 * (0.5f + (_e3821 * (0.16666667f + (_e3821 * (0.041666668f + (_e3821 * (0.008333334f + (_e3821 * (0.001388889f + (_e3821 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3816 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3869 * (1f + (_e3869 * (0.5f + (_e3869 * (0.16666667f + (_e3869 * (0.041666668f + (_e3869 * (0.008333334f + (_e3869 * (0.001388889f + (_e3869 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3864 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e3939 / select(1e-12f, _e3602, (_e3602 > 1e-12f))))));
}
let _e3947 = phi_7140_;
if _e995 {
let _e3951 = global_1.member.member_5.member_2;
let _e3959 = global_1.member.member_5.member_4;
let _e3962 = (_e2731.member_3.x * _e3215.member_2);
let _e3964 = (_e2731.member_3.y * _e3215.member_2);
let _e3966 = (_e2731.member_3.z * _e3215.member_2);
let _e3967 = (0.5f * (_e3951 / select(1e-6f, _e187, (_e187 > 1e-6f))));
let _e3971 = (_e165 + (_e3962 * _e3967));
let _e3972 = (_e176 + (_e3964 * _e3967));
let _e3973 = (_e187 + (_e3966 * _e3967));
let _e3975 = (2f * _e3951);
let _e3977 = ((_e3973 * _e3973) + (_e3975 * _e3966));
let _e3981 = (_e3973 + sqrt(select(0f, _e3977, (_e3977 > 0f))));
let _e3985 = (0.5f * (_e3975 / select(1e-6f, _e3981, (_e3981 > 1e-6f))));
let _e3989 = (_e3971 + (_e3962 * _e3985));
let _e3990 = (_e3972 + (_e3964 * _e3985));
let _e3991 = (_e3973 + (_e3966 * _e3985));
let _e3995 = (_e3959 * _e3959);
let _e3997 = (_e3991 * _e3991);
let _e4005 = (((_e3973 <= 0f) || (_e3977 <= 0f)) || ((_e3991 <= 0f) || (_e3997 <= (_e3995 * (((_e3989 * _e3989) + (_e3990 * _e3990)) + _e3997)))));
let _e4019 = (_e165 + ((_e2731.member_4.x * _e3215.member_2) * _e3951));
let _e4020 = (_e176 + ((_e2731.member_4.y * _e3215.member_2) * _e3951));
let _e4021 = (_e187 + ((_e2731.member_4.z * _e3215.member_2) * _e3951));
let _e4023 = (_e4021 * _e4021);
let _e4032 = ((_e3010 & 1u) != 0u);
let _e4036 = select(_e4005, ((_e4021 <= 0f) || (_e4023 <= (_e3995 * (((_e4019 * _e4019) + (_e4020 * _e4020)) + _e4023)))), _e4032);
phi_7292_ = vec3<f32>(select(select(select(_e3989, _e3971, _e4005), _e4019, _e4032), _e165, _e4036), select(select(select(_e3990, _e3972, _e4005), _e4020, _e4032), _e176, _e4036), select(select(select(_e3991, _e3973, _e4005), _e4021, _e4032), _e187, _e4036));
phi_7293_ = select(1f, 0f, _e4036);
} else {
phi_7292_ = vec3<f32>(_e165, _e176, _e187);
phi_7293_ = 1f;
}
let _e4043 = phi_7292_;
let _e4045 = phi_7293_;
let _e4048 = (_e3947.member * _e4045);
global_5.member[_e122] = (_e133 * (_e3947.member_2.x * _e4048));
global_5.member[_e134] = (_e143 * (_e3947.member_2.y * _e4048));
global_5.member[_e145] = (_e154 * (_e3947.member_2.z * _e4048));
global_5.member[_e156] = _e4043.x;
global_5.member[_e167] = _e4043.y;
global_5.member[_e178] = _e4043.z;
global_5.member[_e189] = _e198;
global_5.member[_e200] = _e209;
global_5.member[_e211] = _e220;
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
